/**
 * The technique `hatching` at one fragment, in double precision: the simplex lattice from its definition (Perlin's
 * skewed cubes), the hash and the blend as documented. Shares no code with the shader.
 */
import { mat4, vec3 } from 'gl-matrix';
import { type HatchingReference, LAYER_SHIFT } from './hatchingReference.js';
import { normalDistribution } from './normalDistribution.js';
import type { ReferenceCamera } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';

/** g = Φ⁻¹(h) of a level of the threshold map at (u, v), in tiles. It has variance 1, and levels are independent. */
export type ThresholdFunction = (u: number, v: number, level: number) => number;

export interface AnchoredSettings {
  tilesPerObjectUnit: number;
  strokeAngle: number;
  latticeSpacing: number;
  /** Whether directions are known up to their sign only, so that the map is shifted by half tiles. */
  halfTiles: boolean;
  screenSpaceShare: number;
  shadowStrokes?: 'tone' | 'cross' | 'reorient';
  /** The axis of strokes that follow the form or a slant, in the tangent plane; left out if they follow the light. */
  axisAt?: (point: Vec3, normal: Vec3, isDark: boolean) => Vec3;
  threshold: ThresholdFunction;
  /** Texels per side of level 0. A texel should cover one pixel. */
  mapSize: number;
  mapLevels: number;
}

/** A field of standard normal distribution, except for the skew of mixed levels. */
interface Field {
  g: number;
  /** 0 on one level, 1 half way between two. */
  mixing: number;
}

const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/**
 * The axis of strokes along the level lines of a function, or across them; where no light arrives they run the other way.
 *
 * @param gradientAt its gradient at a point
 */
export function formAxisOf(
  gradientAt: (point: Vec3) => Vec3,
  isAcross: boolean,
): (point: Vec3, normal: Vec3, isDark: boolean) => Vec3 {
  return (point, normal, isDark) => {
    const gradient = gradientAt(point);
    // The part of the gradient in the tangent plane.
    const away = dot(gradient, normal);
    const within = gradient.map((x, axis) => x - away * normal[axis]) as Vec3;
    const axis = isAcross === isDark ? cross(normal, within) : within;
    return axis.map((x) => x / Math.hypot(...axis)) as Vec3;
  };
}

/** Wellons 2018, lowbias32, over the coordinates of a lattice point and the number of its lattice. */
export function hashAnchor(id: Vec3, lattice: number): number {
  let h = Math.imul(id[0], 0x8da6b343) + Math.imul(id[1], 0xd8163841) + Math.imul(id[2], 0xcb1ab31f);
  h = (h + Math.imul(lattice, 0x9e3779b9)) | 0;
  h ^= h >>> 16;
  h = Math.imul(h, 0x7feb352d);
  h ^= h >>> 15;
  h = Math.imul(h, 0x846ca68b);
  return (h ^ (h >>> 16)) >>> 0;
}

/** The corners of the simplex around x: lattice coordinates, and the vector from the corner to x. */
export function simplexCorners(x: Vec3): { id: Vec3; offset: Vec3 }[] {
  const skew = (x[0] + x[1] + x[2]) / 3;
  const cell = x.map((c) => Math.floor(c + skew)) as Vec3;
  const toSpace = (id: Vec3) => id.map((c) => c - (id[0] + id[1] + id[2]) / 6) as Vec3;
  const origin = toSpace(cell);
  const local = x.map((c, i) => c - origin[i]) as Vec3;
  // From the cell's first corner, walk along the axes in the order of the local coordinates, largest first.
  const axes = [0, 1, 2].sort((a, b) => local[b] - local[a]);
  const ids: Vec3[] = [cell];
  for (const axis of axes) {
    const next = [...ids.at(-1)!] as Vec3;
    next[axis] += 1;
    ids.push(next);
  }
  return ids.map((id) => {
    const place = toSpace(id);
    return { id, offset: x.map((c, i) => c - place[i]) as Vec3 };
  });
}

/** The axis of strokes at a slant: the tangent along which the picture of a point moves at that angle to the horizontal. */
export function slantAxisOf(
  { view, projection }: ReferenceCamera,
  matrixWorld: readonly number[],
  angle: number,
): (point: Vec3, normal: Vec3) => Vec3 {
  const toClip = [projection, view, matrixWorld].map((m) => m as unknown as mat4);
  const objectToClip = toClip.slice(1).reduce((all, m) => mat4.multiply(mat4.create(), all, m), toClip[0]);
  const onScreen = (point: Vec3) => vec3.transformMat4([0, 0, 0], point, objectToClip) as Vec3;
  return (point, normal) => {
    /** The motion of the point on the picture, along the slant and across it, per step along each axis of the object. */
    const moves = [0, 1, 2].map((axis) => {
      const [from, to] = [-1e-5, 1e-5].map((step) =>
        onScreen(point.map((c, i) => c + (i === axis ? step : 0)) as Vec3),
      );
      const [x, y] = [to[0] - from[0], to[1] - from[1]];
      return [Math.cos(angle) * x + Math.sin(angle) * y, Math.cos(angle) * y - Math.sin(angle) * x];
    });
    const axis = cross(normal, moves.map(([, across]) => across) as Vec3);
    const sign = Math.sign(dot(axis, moves.map(([along]) => along) as Vec3));
    return axis.map((x) => (sign * x) / Math.hypot(...axis)) as Vec3;
  };
}

/** Octaves by which strokes are coarser than face on: none until their distance on the screen is less than half of that face on. */
function crowdedOctaves(across: Vec3, normal: Vec3, toViewer: Vec3): number {
  const angle = Math.atan2(Math.abs(dot(across, toViewer)), Math.abs(dot(normal, toViewer)));
  return Math.max(0, -1 - Math.log2(Math.max(Math.cos(angle), 0.01)));
}

/** The field at a point in object space, by the width of a pixel in object units and the octaves by which strokes are coarser. */
function anchoredField(
  point: Vec3,
  tangent: Vec3,
  bitangent: Vec3,
  unitsPerPixel: number,
  coarser: number,
  settings: AnchoredSettings,
): Field {
  const magnification = -Math.log2(settings.tilesPerObjectUnit * unitsPerPixel * settings.mapSize);
  const wanted = settings.screenSpaceShare * magnification;
  const lattice = Math.ceil(wanted);
  const octaves = lattice - magnification + coarser;
  const coarse = latticeField(point, tangent, bitangent, lattice, octaves, settings);
  if (settings.screenSpaceShare === 0) return coarse;
  // The fade covers the last three quarters of the way to the next lattice.
  const way = Math.min(1, Math.max(0, (1 - lattice + wanted - 0.25) / 0.75));
  const fade = way * way * (3 - 2 * way);
  const fine = latticeField(point, tangent, bitangent, lattice + 1, octaves + 1, settings);
  return {
    g: ((1 - fade) * coarse.g + fade * fine.g) / Math.hypot(1 - fade, fade),
    mixing: fade === 0 ? coarse.mixing : Math.max(coarse.mixing, fine.mixing),
  };
}

/** The field of one lattice, with the octaves by which the map would be too fine for it. */
function latticeField(
  point: Vec3,
  tangent: Vec3,
  bitangent: Vec3,
  lattice: number,
  octaves: number,
  settings: AnchoredSettings,
): Field {
  const { tilesPerObjectUnit, strokeAngle, latticeSpacing, threshold } = settings;
  const edge = latticeSpacing / (tilesPerObjectUnit * 2 ** lattice);
  const cos = Math.cos(strokeAngle);
  const sin = Math.sin(strokeAngle);
  const level = Math.min(Math.max(octaves, 0), settings.mapLevels - 1);
  const finer = Math.floor(level);
  const share = level - finer;
  let sum = 0;
  let squares = 0;
  for (const { id, offset } of simplexCorners(point.map((c) => c / edge) as Vec3)) {
    const weight = Math.max(0.5 - dot(offset, offset), 0) ** 6;
    const hash = hashAnchor(id, lattice);
    const shift = (word: number) => (settings.halfTiles ? 0.5 * (word & 1) : word / 65536);
    const s = dot(offset, tangent) * latticeSpacing;
    const t = dot(offset, bitangent) * latticeSpacing;
    const u = (s * cos - t * sin) * (hash & 0x8000 ? -1 : 1) + shift(hash & 0xffff);
    const v = s * sin + t * cos + shift(hash >>> 16);
    const mixed = share === 0 ? 0 : share * threshold(u, v, finer + 1);
    sum += (weight * ((1 - share) * threshold(u, v, finer) + mixed)) / Math.hypot(1 - share, share);
    squares += weight * weight;
  }
  return { g: sum / Math.sqrt(squares), mixing: 4 * share * (1 - share) * Math.min(1, 2 * share) };
}

/** h of a field: uniform, with the skew of mixed levels corrected by a fit to generated maps. */
function uniformOf({ g, mixing }: Field): number {
  const h = normalDistribution(g);
  return h + mixing * h * (1 - h) * (1.07 * (h - 0.42) ** 2 - 0.14);
}

/** Tone minus threshold, in the layer where it is greatest. Above 0 there is ink. */
export function anchoredExcess(
  reference: HatchingReference,
  point: Vec3,
  strokeNormal: Vec3,
  toneNormal: Vec3,
  unitsPerPixel: number,
  settings: AnchoredSettings,
): number {
  const world = reference.toWorld(point);
  const edge = settings.latticeSpacing / settings.tilesPerObjectUnit;
  const toViewer = reference.toViewer(world);
  const worldNormal = reference.normalToWorld(toneNormal);
  const axis = settings.axisAt?.(point, strokeNormal, reference.isDark(worldNormal, world));
  const { tangent, bitangent, crossing } = axis
    ? { tangent: axis, bitangent: cross(strokeNormal, axis), crossing: 0 }
    : reference.frameOfNormal(strokeNormal, world);
  const strokeAngle = axis ? 0 : settings.strokeAngle;
  const tone = reference.tone(world, worldNormal);
  const unshadowed = reference.tone(world, worldNormal, false);
  const isCrossed = settings.shadowStrokes === 'cross';
  const layers = reference.layers(isCrossed ? unshadowed : tone, crossing).map((layer, i) => ({ ...layer, shift: i }));
  // A layer for shadows crosses the strokes of the light and adds the missing tone. Its shift follows those of all other layers.
  if (isCrossed && tone > unshadowed) {
    layers.push({ tone: 1 - (1 - tone) / (1 - unshadowed), angle: Math.PI / 2, shift: 3 });
  }
  const excesses = layers.map((layer) => {
    const at = point.map((c, axis) => c + layer.shift * LAYER_SHIFT[axis] * edge) as Vec3;
    const turned = { ...settings, strokeAngle: strokeAngle + layer.angle };
    const { strokeAngle: angle } = turned;
    const across = tangent.map((x, axis) => Math.sin(angle) * x + Math.cos(angle) * bitangent[axis]) as Vec3;
    const coarser = crowdedOctaves(across, strokeNormal, toViewer);
    return layer.tone - uniformOf(anchoredField(at, tangent, bitangent, unitsPerPixel, coarser, turned));
  });
  return Math.max(...excesses);
}
