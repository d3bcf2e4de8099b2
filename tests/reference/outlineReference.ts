/** Outlines at one place, in double precision, by their documentation. Shares no code with the shaders. */
import { vec3 } from 'gl-matrix';
import type { Vec3 } from './referenceAdjacency.js';
import { cross, dot, mixed, smoothly, unit } from './vectors.js';

/** The share of its width that a contour has at a curvature: it ends where that is 0. */
export const taperedTo = (bend: number, taper: number): number => {
  if (taper === 0) return bend < 0 ? 0 : 1;
  return smoothly(0, taper, bend);
};

/** The part of an edge where one side faces the eye and the other does not. Cosines at both ends, linear between them. */
export function partInContour(
  left: readonly [number, number],
  right: readonly [number, number],
): [number, number] | null {
  const at = ([start, end]: readonly [number, number], t: number) => (1 - t) * start + t * end;
  const turns = [left, right].map(([start, end]) => start / (start - end)).filter((t) => t > 0 && t < 1);
  const ends = [0, ...turns.toSorted((a, b) => a - b), 1];
  const differs = ends.slice(1).map((end, i) => {
    const middle = (ends[i] + end) / 2;
    return at(left, middle) > 0 !== at(right, middle) > 0;
  });
  const first = differs.indexOf(true);
  return first < 0 ? null : [ends[first], ends[differs.lastIndexOf(true) + 1]];
}

export interface OutlineShade {
  /** Unit. */
  light: Vec3;
  sight: Vec3;
  lit: number;
  shaded: number;
  lostEdges: number;
}

/** Factors on the width before a surface, and before paper. contour: share of the piece that is one. */
export function shadedWidths(
  normal: Vec3,
  contour: number,
  { light, sight, lit, shaded, lostEdges }: OutlineShade,
): [number, number] {
  const inShade = smoothly(0.15, 0.85, (1 - dot(normal, light)) / 2);
  const before = lit * (1 - inShade) + shaded * inShade;
  // Just inside, the normal leans halfway to the eye. The brightest part of the contour is lost first, over 0.7 of the cosine.
  const inside = dot(unit(mixed(normal, 2, sight, 1)), light);
  const end = 1 - 0.7 * lostEdges;
  const thinnest = 0.47 - 0.35 * lostEdges;
  return [before, before - before * contour * (1 - thinnest) * smoothly(end, end + 0.05 + 0.35 * lostEdges, inside)];
}

/**
 * Distance by which an outline is lifted towards the eye. R: bounding radius, half: half of its width, extent: depth of its triangle; in
 * one unit. bend: R times the curvature, or null at an edge.
 */
export function liftedBy(bend: number | null, extent: number, half: number, R: number): number {
  if (bend === null) return 0.004 * R + extent + 6 * half;
  const curvature = Math.max(bend, 0.001) / R;
  return 0.004 * R + extent + 2 * half + Math.min(Math.sqrt((2 * half) / curvature), 0.11 * R);
}

/** Distance by which a surface may lie before its own outline. pixel: its size; at a concave edge both sides rise by three pixels. */
export const mayLieBefore = (ownCover: number, isValley: boolean, pixel: number, R: number): number =>
  ownCover + R / 2000 + (isValley ? 6 * pixel : 0);

/** The share of paper, if the background is so many heights of the view behind. */
export const paperBehind = (gap: number): number => smoothly(0.25, 0.75, gap);

/** The weight of a hidden outline. */
export const behindSurface = (weight: number): number => smoothly(0, 0.2, weight) / 2;

/** The wobble of an outline at a place, in bounding radii. */
export function strayed(place: Vec3, wobble: number): [number, number] {
  const bent = (along: Vec3, by: number, other: Vec3, phase: number) =>
    Math.sin(dot(place, along) + by * Math.sin(dot(place, other)) + phase);
  const fine = Math.sin(dot(place, [23, -19, 17]) + 4) / 5;
  const across = 0.8 * bent([11.3, 7.1, -5.9], 1.7, [-4.3, 6.7, 9.1], 0);
  const up = 0.8 * bent([-6.1, 9.7, 12.7], 1.3, [8.9, -3.7, 5.3], 2);
  return [(across + fine) * wobble, (up - fine) * wobble];
}

/** The share of its width that a suggestive contour has on a triangle. bends: at its corners, R times the curvature. */
export function suggestedBy(
  corners: readonly [Vec3, Vec3, Vec3],
  normals: readonly [Vec3, Vec3, Vec3],
  bends: Vec3,
  toEye: Vec3,
  R: number,
): number {
  const [a, b, c] = corners;
  const [ab, ac] = [mixed(b, 1, a, -1), mixed(c, 1, a, -1)];
  // The gradient in the plane, from its products with both edges.
  const [aa, bb, mid] = [dot(ab, ab), dot(ac, ac), dot(ab, ac)];
  const [x, y] = [bends[1] - bends[0], bends[2] - bends[0]];
  const determinant = aa * bb - mid * mid;
  const gradient = mixed(ab, (x * bb - y * mid) / determinant, ac, (y * aa - x * mid) / determinant);
  const n = unit(normals.reduce<Vec3>((sum, normal) => mixed(sum, 1, normal, 1), [0, 0, 0]));
  const v = unit(toEye);
  const w = cross(n, cross(v, n));
  const growth = R * dot(gradient, unit(w));
  return smoothly(20, 60, growth * smoothly(0.1, 0.35, vec3.length(w)));
}

/** The depth of a triangle beside a piece of contour on it. */
export function depthBeside(corners: readonly Vec3[], start: Vec3, end: Vec3, toEye: Vec3): number {
  const along = unit(mixed(end, 1, start, -1));
  const depths = corners.map((corner) => {
    const beside = mixed(corner, 1, along, -dot(corner, along));
    return dot(beside, unit(toEye));
  });
  return Math.max(...depths) - Math.min(...depths);
}
