/** Models made by code. All stand on a plane of constant y, or float. */
import {
  type BufferGeometry,
  IcosahedronGeometry,
  LatheGeometry,
  MathUtils,
  SplineCurve,
  TorusKnotGeometry,
  Vector2,
} from 'three';
import { ParametricGeometry } from 'three/addons/geometries/ParametricGeometry.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { gearWheel } from './gearWheel.js';

const TURN = 2 * Math.PI;

/** A point of a surface, for u and v in [0, 1]. */
type Surface = (u: number, v: number) => [x: number, y: number, z: number];

/** A grid of `columns` by `rows` quads on a surface. */
const grid = (columns: number, rows: number, surface: Surface): BufferGeometry =>
  new ParametricGeometry((u, v, place) => void place.set(...surface(u, v)), columns, rows);

export const teapot = (): BufferGeometry => new TeapotGeometry(1, 12);

export const sphere = (): BufferGeometry => new IcosahedronGeometry(1, 12);

export const knot = (): BufferGeometry => new TorusKnotGeometry(0.7, 0.24, 320, 40, 2, 3);

const WHORLS = 4.5;
/** The ratio of the sizes of consecutive whorls. */
const GROWTH = 1.9;

/** A sea snail: a growing tube that winds around a leaning axis, with ribs across it. */
export const shell = (): BufferGeometry =>
  grid(72, 520, (u, v) => {
    const turn = TURN * WHORLS * v;
    const size = GROWTH ** (WHORLS * (v - 1));
    const rib = 1 + 0.035 * Math.sin(11 * turn) * Math.cos(TURN * u) ** 2;
    const radius = 0.62 * size * rib;
    const around = TURN * u;
    const out = 0.62 * size + radius * Math.cos(around);
    const along = 1.9 * (1 - size) + 1.15 * radius * Math.sin(around);
    const [x, y, z] = [out * Math.cos(turn), along, out * Math.sin(turn)];
    const lean = 1.05;
    return [x * Math.cos(lean) - y * Math.sin(lean), x * Math.sin(lean) + y * Math.cos(lean), z];
  });

/** A vase with a wall; foot, belly and lip in one profile. */
export function vase(): BufferGeometry {
  const outer = [
    [0.001, 0],
    [0.34, 0],
    [0.36, 0.04],
    [0.28, 0.1],
    [0.3, 0.18],
    [0.46, 0.4],
    [0.6, 0.66],
    [0.64, 0.92],
    [0.58, 1.16],
    [0.42, 1.36],
    [0.28, 1.5],
    [0.22, 1.64],
    [0.23, 1.76],
    [0.31, 1.88],
    [0.34, 1.9],
  ] as const;
  const inner = [
    [0.31, 1.9],
    [0.2, 1.76],
    [0.19, 1.62],
    [0.38, 1.34],
    [0.55, 1.1],
    [0.55, 0.7],
    [0.3, 0.3],
    [0.001, 0.2],
  ] as const;
  const smooth = (points: readonly (readonly [number, number])[], steps: number): Vector2[] =>
    new SplineCurve(points.map(([x, y]) => new Vector2(x, y))).getPoints(steps * (points.length - 1));
  return new LatheGeometry([...smooth(outer, 6), ...smooth(inner, 4)], 96);
}

const FLUTES = 20;
/** Radius of the column by height, without flutes. */
const COLUMN: readonly (readonly [radius: number, height: number])[] = [
  [0.001, 0],
  [0.46, 0],
  [0.46, 0.12],
  [0.42, 0.13],
  [0.45, 0.2],
  [0.42, 0.27],
  [0.36, 0.29],
  [0.39, 0.34],
  [0.36, 0.39],
  [0.31, 0.42],
  [0.31, 0.5],
  [0.27, 2.5],
  [0.27, 2.56],
  [0.32, 2.6],
  [0.3, 2.63],
  [0.42, 2.76],
  [0.5, 2.8],
  [0.5, 2.94],
  [0.001, 2.94],
];

/** A column with a base, a tapering fluted shaft and a plain capital. */
export function column(): BufferGeometry {
  const rings = COLUMN.flatMap(([radius, height], i) => {
    const next = COLUMN[i + 1];
    // The shaft needs rings of vertices: its flutes end in them, and strokes follow them.
    const steps = next && next[1] - height > 1 ? 24 : 1;
    return Array.from({ length: steps }, (_, step) => {
      const t = step / steps;
      return next
        ? ([radius + (next[0] - radius) * t, height + (next[1] - height) * t] as const)
        : ([radius, height] as const);
    });
  });
  return grid(FLUTES * 10, rings.length - 1, (u, v) => {
    const [radius, height] = rings[Math.round(v * (rings.length - 1))];
    const inShaft = height > 0.5 && height < 2.5 ? Math.min(1, (height - 0.5) / 0.1, (2.5 - height) / 0.1) : 0;
    const flute = 1 - 0.11 * inShaft * Math.abs(Math.sin((FLUTES * TURN * u) / 2)) ** 0.8;
    const angle = -TURN * u;
    return [radius * flute * Math.cos(angle), height, radius * flute * Math.sin(angle)];
  });
}

/** Two meshing gear wheels. */
export function gears(): BufferGeometry {
  const wheel = (): BufferGeometry => mergeGeometries(gearWheel())!;
  // The second wheel is two pitch radii away, and turned by half a tooth.
  const other = wheel()
    .rotateZ(TURN * (0.3 / 20))
    .translate(1.76, 0, 0);
  return mergeGeometries([wheel(), other])!.translate(-0.88, 0, 0).rotateX(-0.9);
}

const HILLS = 150;

/** A block of mountains: ridges, valleys and a lake. */
export function landscape(): BufferGeometry {
  const floor = -0.34;
  return grid(HILLS, HILLS, (u, v) => {
    // The outermost rows go down to the floor and form the sides of the block.
    const [x, z] = [u, v].map((w) => MathUtils.clamp((w * HILLS - 1) / (HILLS - 2), 0, 1));
    const isSide = u === 0 || v === 0 || u === 1 || v === 1;
    return [2 * x - 1, isSide ? floor : heightAt(x, z), 1 - 2 * z];
  });
}

function heightAt(x: number, z: number): number {
  let [sum, weight] = [0, 0.52];
  let ridge = 1;
  for (let octave = 0, scale = 2.2; octave < 5; octave++, scale *= 2.07) {
    ridge =
      (1 - Math.abs(2 * noise(x * scale + 7 * octave + 3, z * scale + 3 * octave + 1) - 1)) ** 2 * (0.4 + 0.6 * ridge);
    sum += weight * ridge;
    weight *= 0.46;
  }
  return Math.max(-0.08, 0.95 * sum - 0.3);
}

/** Smooth noise in [0, 1] on an integer lattice. */
function noise(x: number, z: number): number {
  const [i, j] = [Math.floor(x), Math.floor(z)];
  const [s, t] = [x - i, z - j].map((w) => MathUtils.smootherstep(w, 0, 1));
  const { lerp } = MathUtils;
  return lerp(lerp(chance(i, j), chance(i + 1, j), s), lerp(chance(i, j + 1), chance(i + 1, j + 1), s), t);
}

/** A reproducible number in [0, 1) for a point of the lattice. */
function chance(i: number, j: number): number {
  let bits = Math.imul(i, 0x27d4eb2d) ^ Math.imul(j, 0x165667b1);
  bits = Math.imul(bits ^ (bits >>> 15), 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35);
  return ((bits ^ (bits >>> 16)) >>> 0) / 2 ** 32;
}
