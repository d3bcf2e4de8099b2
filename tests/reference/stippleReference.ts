/**
 * The medium `stipple` at one fragment, in double precision, by its documentation: planes, a self-similar point set, discs on the screen.
 * Shares no code with the shader, except the table of points.
 */
import { mat3, mat4, vec3 } from 'gl-matrix';
import { STIPPLE_MAP_SIZE } from '../../src/material/tam/patternSizes.js';
import { stippleMap } from '../../src/material/tam/stippleMap.js';
import type { HatchingReference } from './hatchingReference.js';
import type { ReferenceCamera } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';

export interface StippleScene {
  reference: HatchingReference;
  matrixWorld: number[];
  camera: ReferenceCamera;
  /** The width and height of the picture, in pixels. */
  size: number;
  settings: { tilesPerUnit: number; strokeWidth: number; sizedOnScreen: number; edgePixels: number };
}

type Vec2 = [number, number];

const dot = (a: Vec3, b: Vec3) => vec3.dot(a, b);
const cross = (a: Vec3, b: Vec3) => vec3.cross([0, 0, 0], a, b) as Vec3;
const unit = (a: Vec3) => vec3.normalize([0, 0, 0], a) as Vec3;
const clamp01 = (x: number) => Math.min(1, Math.max(0, x));

/** The thirteen axes of a cube: through its faces, edges and corners, one of each opposite pair. */
const AXES: readonly Vec3[] = [-1, 0, 1]
  .flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z): Vec3 => [x, y, z])))
  .slice(14)
  .map(unit);

/** The axes near the normal of a surface, on its front side, with their shares. */
function planesOf(normal: Vec3): { axis: Vec3; share: number }[] {
  const facing = AXES.map((axis) => Math.abs(dot(axis, normal)));
  const best = Math.max(...facing);
  const weights = facing.map((value) => clamp01(1 - (best - value) / 0.03) ** 2);
  const sum = weights.reduce((total, weight) => total + weight, 0);
  return AXES.map((axis, i) => ({
    axis: axis.map((x) => (dot(axis, normal) < 0 ? -x : x) + 0) as Vec3,
    share: weights[i] / sum,
  })).filter(({ share }) => share >= 0.02);
}

/** The share of paper that dots cover: the tone up to half tone, and all of it from 0.85 on. */
const coverOf = (tone: number) => Math.min(1, tone + 0.05 * (Math.max(0, tone - 0.7) / 0.25) ** 2);

/** Offset of the point set along both axes of a plane, per axis of space, in tiles. */
const SHIFTS: readonly Vec3[] = [
  [3.17, 7.71, 5.39],
  [7.71, 5.39, 3.17],
];

/** Two axes in a plane. */
function acrossAxis(axis: Vec3): [Vec3, Vec3] {
  const u = unit(Math.abs(axis[0]) > Math.abs(axis[2]) ? [-axis[1], axis[0], 0] : [0, -axis[2], axis[1]]);
  return [u, cross(axis, u)];
}

const texels = stippleMap().image.data as Uint8Array;

/** The part of an octave over which a dot grows. */
const GROWTH = 0.35;

/** The area of a dot during an octave, as a share of its full area. */
const grownBy = (octave: number, birth: number): number =>
  birth === 0 ? 1 : clamp01((octave - birth * (1 - GROWTH)) / GROWTH);

/** The mean area over all times of appearance, exact since the area is linear between them. */
function meanGrown(octave: number): number {
  const ends = [0, (octave - GROWTH) / (1 - GROWTH), octave / (1 - GROWTH), 1].map(clamp01).toSorted((a, b) => a - b);
  let sum = 0;
  for (let i = 1; i < ends.length; i++) {
    const [from, to] = [ends[i - 1], ends[i]];
    sum += (to - from) * grownBy(octave, Math.max((from + to) / 2, 1e-9));
  }
  return sum;
}

/** The total area of discs for a cover during an octave. Discs overlap, so it is larger than the cover. */
function areaFor(covered: number, octave: number): number {
  if (covered <= 0.5) return covered;
  return (
    covered +
    ((0.25 + 2.8 * octave * (1 - octave) ** 2) * (covered - 0.5) ** 2) / Math.sqrt(Math.max(1 - covered, 0.001))
  );
}

/** The ink of a disc with a soft edge, by the distance from its middle. Discs smaller than their edge become paler. */
function discInk(away: number, area: number, edge: number): number {
  const squared = area / Math.PI;
  const radius = Math.sqrt(Math.max(squared - edge ** 2 / 12, edge ** 2 / 4));
  return clamp01((radius - away) / edge + 0.5) * Math.min((3 * squared) / edge ** 2, 1);
}

export class StippleReference {
  constructor(private readonly scene: StippleScene) {}

  /** The darkness at a fragment, from its position in object space and the interpolated normals for strokes (object) and tone (world). */
  darkness(place: Vec3, normal: Vec3, toneNormal: Vec3): number {
    const { reference, settings } = this.scene;
    const tone = reference.tone(reference.toWorld(place), unit(toneNormal));
    const n = unit(normal);
    const toViewer = unit(reference.toViewer(reference.toWorld(place)));
    // No scene shows a back face.
    const pull = Math.max(dot(n, toViewer), 0.5);
    const between = unit(n.map((x, i) => pull * x + toViewer[i]) as Vec3);
    const { toScreen, lie } = this.screenMap(place, n);
    const cover = coverOf(tone);
    if (cover >= 1) return 1;
    let blank = 1;
    for (const { axis, share } of planesOf(between)) {
      const [u, v] = acrossAxis(axis);
      const moves = [u, v].map((side) => {
        // A step in the plane, projected along the axis onto the surface.
        const lifted = side.map((x, i) => x - (axis[i] * dot(side, lie)) / dot(axis, lie)) as Vec3;
        return toScreen(lifted);
      }) as [Vec2, Vec2];
      const at = [u, v].map((side, i) => dot(place, side) + dot(axis, SHIFTS[i]) / settings.tilesPerUnit) as Vec2;
      blank *= 1 - this.dots(at, moves, 1 - (1 - cover) ** share);
    }
    // The last specks of paper fill.
    return 1 - blank * Math.min(1, (1 - cover) / 0.03);
  }

  /** The ink of one plane, whose dots cover `own`. `moves`: pixels per step along each of its axes. */
  private dots(at: Vec2, moves: [Vec2, Vec2], own: number): number {
    const { tilesPerUnit, strokeWidth, sizedOnScreen, edgePixels } = this.scene.settings;
    const pixelArea = Math.abs(moves[0][0] * moves[1][1] - moves[0][1] * moves[1][0]);
    // The diameter of a dot at half tone is 0.8 of the distance between dots. Dots per unit of length.
    const onPaper = Math.sqrt(pixelArea) / (strokeWidth / 0.8);
    const onObject = Math.min(64 * tilesPerUnit, onPaper);
    // Randomly placed discs of one size leave exp(−area) blank. The number of dots is close to theirs.
    const crowded = (Math.log(1 - Math.max(own, 0.02)) / Math.log(0.5)) ** 0.45;
    const octave = Math.log2(onObject ** (1 - sizedOnScreen) * onPaper ** sizedOnScreen * crowded);
    const cells = 2 ** (Math.floor(octave) + 1);
    const into = octave - Math.floor(octave);
    const dotArea = (areaFor(own, into) * pixelArea) / cells ** 2 / (0.25 + 0.75 * meanGrown(into));
    let ink = 0;
    const [column, row] = at.map((coordinate) => Math.floor(coordinate * cells));
    for (let y = row - 3; y <= row + 3; y++) {
      for (let x = column - 3; x <= column + 3; x++) {
        const wrap = (cell: number) => ((cell % STIPPLE_MAP_SIZE) + STIPPLE_MAP_SIZE) % STIPPLE_MAP_SIZE;
        const texel = 4 * (wrap(y) * STIPPLE_MAP_SIZE + wrap(x));
        const du = (x + texels[texel] / 255) / cells - at[0];
        const dv = (y + texels[texel + 1] / 255) / cells - at[1];
        const away = Math.hypot(du * moves[0][0] + dv * moves[1][0], du * moves[0][1] + dv * moves[1][1]);
        const area = dotArea * grownBy(into, texels[texel + 2] / 255);
        ink += discInk(away, area, Math.max(edgePixels, 0.01));
      }
    }
    return Math.min(ink, 1);
  }

  /** Pixels per step in object space, from the derivatives of the whole projection, and the slant of the surface. */
  private screenMap(place: Vec3, normal: Vec3): { toScreen: (step: Vec3) => Vec2; lie: Vec3 } {
    const { camera, matrixWorld, size } = this.scene;
    const objectToView = mat4.multiply(mat4.create(), camera.view as unknown as mat4, matrixWorld as unknown as mat4);
    const linear = mat3.fromMat4(mat3.create(), objectToView);
    const q = vec3.transformMat4([0, 0, 0], place, objectToView) as Vec3;
    const p = camera.projection;
    const clip = (row: number, v: Vec3, w: number) =>
      p[row] * v[0] + p[4 + row] * v[1] + p[8 + row] * v[2] + p[12 + row] * w;
    const depth = clip(3, q, 1);
    // The quotient rule: x/w changes by (dx − x/w · dw)/w.
    const moved = (row: number, v: Vec3) =>
      ((clip(row, v, 0) - (clip(row, q, 1) / depth) * clip(3, v, 0)) / depth) * (size / 2);
    const toScreen = (step: Vec3): Vec2 => {
      const inView = vec3.transformMat3([0, 0, 0], step, linear) as Vec3;
      return [moved(0, inView), moved(1, inView)];
    };
    // The angle is limited: a cosine below 0.33 counts as 0.33. It is the cosine to a line of sight whose length is the depth.
    const toObject = mat3.invert(mat3.create(), linear)!;
    const inView = unit(vec3.transformMat3([0, 0, 0], normal, mat3.transpose(mat3.create(), toObject)) as Vec3);
    const isPerspective = p[11] !== 0;
    const sight: Vec3 = isPerspective ? [q[0] / q[2], q[1] / q[2], 1] : [0, 0, 1];
    const lacking = Math.max(0.33 - dot(inView, sight), 0) / dot(sight, sight);
    const leaning = inView.map((x, i) => x + lacking * sight[i]) as Vec3;
    return { toScreen, lie: vec3.transformMat3([0, 0, 0], leaning, mat3.transpose(mat3.create(), linear)) as Vec3 };
  }
}
