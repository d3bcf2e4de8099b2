/** Dots that are fixed on the surface and round on the screen, as in shaders/techniques/strokes/stipple.glsl and dots.glsl. */

import { STIPPLE_CONSTANTS } from '../../look/constants/patternConstants.js';
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { clamp01, combined, cross, dot, lengthOf, normalize, type Vec3 } from '../../look/vectors.js';
import { leftOf, THIRD_FROM, takenOf } from './crossedTones.js';
import type { ScreenMap } from './screenGradient.js';

const { LEAST_PULL, PLANE_FADE, LEAST_SHARE, LEAST_ROUND, CLOSING, SET_SHIFT } = STIPPLE_CONSTANTS;
const { DOTS_PER_TILE, DOT_SHARE, CROWDING, LEAST_DENSE_SHARE } = STIPPLE_CONSTANTS;
const { DOT_GROWTH, OVERLAP, OVERLAP_WITHIN, LEAST_BLANK } = STIPPLE_CONSTANTS;

/**
 * The point set of dots. Each cell has four numbers: the position of its point within it, 255 for 1, and the part of an octave at which it
 * appears.
 */
export interface DotSet {
  /** Cells per side, after which the set repeats. */
  cells: number;
  texels: Uint8Array;
}

/** A plane of dots at a place. */
export interface DotPlane {
  /** Unit normal, and two axes in the plane. Object space. */
  axis: Vec3;
  u: Vec3;
  v: Vec3;
  /** Its share of the dots. */
  share: number;
}

/**
 * The direction that chooses the planes: half way from the normal to the viewer, nearer to the viewer at grazing angles. front, toViewer:
 * unit.
 */
export const directionOfNeedles = (front: Vec3, toViewer: Vec3): Vec3 =>
  normalize(combined(Math.max(dot(front, toViewer), LEAST_PULL), front, 1, toViewer));

/** A tangent of a unit vector. */
const anyTangent = ([x, y, z]: Vec3): Vec3 => normalize(Math.abs(x) > Math.abs(z) ? [-y, x, 0] : [0, -z, y]);

/** The planes nearest to a direction, perpendicular to axes of a cube through its faces, edges and corners. */
export function planesNear(direction: Vec3): DotPlane[] {
  const size = direction.map(Math.abs);
  const order = [0, 1, 2].toSorted((a, b) => size[b] - size[a]);
  const axes = [1, 2, 3].map((count): Vec3 => {
    const [x, y, z] = [0, 1, 2].map((k) => (order.indexOf(k) < count ? (direction[k] < 0 ? -1 : 1) : 0));
    return normalize([x, y, z]);
  });
  const cosines = axes.map((axis) => dot(axis, direction));
  const best = Math.max(...cosines);
  const weights = cosines.map((cosine) => clamp01(1 + (cosine - best) / PLANE_FADE) ** 2);
  const sum = weights[0] + weights[1] + weights[2];
  const planes: DotPlane[] = [];
  for (const [i, axis] of axes.entries()) {
    const share = weights[i] / sum;
    if (share < LEAST_SHARE) continue;
    const u = anyTangent(axis);
    planes.push({ axis, u, v: cross(axis, u), share });
  }
  return planes;
}

/** The screen map of the tangent plane, with the angle limited to where dots stay round. */
export function roundScreenMap(map: ScreenMap, unitsPerPixel: number): ScreenMap {
  const toViewer: Vec3 = [map.centre[0], map.centre[1], 1];
  const facing = dot(map.normal, toViewer);
  const least = LEAST_ROUND * lengthOf(map.normal);
  const lacking = Math.max(least - facing, 0);
  const normal = combined(1, map.normal, lacking / dot(toViewer, toViewer), toViewer);
  return { ...map, normal, scale: unitsPerPixel / Math.max(facing, least, 1e-30) };
}

/** The share that dots cover at a tone: the tone itself in the lights, more in the darks, which end solid. */
export function coverOf(tone: number): number {
  const way = clamp01((tone - CLOSING[0]) / (CLOSING[1] - CLOSING[0]));
  return Math.min(tone + (1 - CLOSING[1]) * way * way, 1);
}

/** The share that a plane's dots cover alone, so that all planes printed over one another give the total. */
export const ownCover = (cover: number, share: number): number => 1 - (1 - cover) ** share;

/** The size of dots. */
export interface DotSize {
  /** The diameter at half tone, pixels. */
  dotPixels: number;
  tilesPerObjectUnit: number;
  /** 0: spaced on the object, 1: on the screen. */
  screenSpaceShare: number;
}

/**
 * The logarithm to base 2 of cells per object unit.
 *
 * @param pixelArea object units² per pixel, above 0
 * @param own the share that the plane's dots cover alone
 */
export function dotOctave(
  pixelArea: number,
  own: number,
  { dotPixels, tilesPerObjectUnit, screenSpaceShare }: DotSize,
): number {
  const onObject = Math.log2(tilesPerObjectUnit * DOTS_PER_TILE);
  const onScreen = -0.5 * Math.log2(Math.max(pixelArea, 1e-30)) - Math.log2(dotPixels / DOT_SHARE);
  const least = Math.min(onObject, onScreen);
  const crowding = 0.5 * CROWDING * Math.log2(-Math.log2(1 - Math.max(own, LEAST_DENSE_SHARE)));
  return least + screenSpaceShare * (onScreen - least) + crowding;
}

/** The layers of dots, and the distance between them. */
export interface DotLayers {
  /** Distance between anchors, object units. */
  shift: number;
  /** Tones from which on a second and a third layer take a share; null for a single layer. */
  crossFrom: number | null;
}

/** The tone of each layer of dots; printed over one another they give the total. */
export function layerTones(tone: number, { crossFrom }: DotLayers): readonly number[] {
  if (crossFrom === null) return [tone];
  const first = takenOf(tone, crossFrom);
  const others = leftOf(tone, first);
  const second = takenOf(others, THIRD_FROM);
  return [first, second, leftOf(others, second)];
}

/** A position in the set of a layer. Object space. */
export const inLayer = (place: Vec3, layer: number, { shift }: DotLayers): Vec3 =>
  combined(1, place, layer * shift, TONE_CONSTANTS.LAYER_SHIFT);

/** Offset of the set from the origin of a plane, object units along both of its axes. */
export const setShift = (axis: Vec3, tilesPerObjectUnit: number): readonly [number, number] => [
  dot(axis, SET_SHIFT) / tilesPerObjectUnit,
  dot(axis, [SET_SHIFT[1], SET_SHIFT[2], SET_SHIFT[0]]) / tilesPerObjectUnit,
];

/** The mean area, as a share of the full one, of the dots that appear during an octave. */
function grownShare(octave: number): number {
  const covered = (t: number): number => (t < DOT_GROWTH ? (0.5 * t * t) / DOT_GROWTH : t - 0.5 * DOT_GROWTH);
  return (covered(Math.max(octave, 0)) - covered(Math.max(octave + DOT_GROWTH - 1, 0))) / (1 - DOT_GROWTH);
}

/** The area of a dot during an octave, as a share of its full area. born: 0 for dots of the octave before. */
export const grownBy = (octave: number, born: number): number =>
  born === 0 ? 1 : clamp01((octave - born * (1 - DOT_GROWTH)) / DOT_GROWTH);

/** The total area of discs that together cover a share of the plane, as a share of the plane. */
function discArea(covered: number, octave: number): number {
  const beyond = Math.max(covered - 0.5, 0);
  const overlap = OVERLAP + OVERLAP_WITHIN * octave * (1 - octave) ** 2;
  return covered + (overlap * beyond * beyond) / Math.sqrt(Math.max(1 - covered, LEAST_BLANK));
}

/** The area of a full-grown dot, pixels. octave: of the cells. */
export function dotArea(pixelArea: number, own: number, octave: number): number {
  const into = octave - Math.floor(octave);
  const cells = 2 ** (Math.floor(octave) + 1);
  // A quarter of the cells had their dots before this octave.
  return discArea(own, into) / (Math.max(pixelArea, 1e-20) * cells * cells * (0.25 + 0.75 * grownShare(into)));
}
