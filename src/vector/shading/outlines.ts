/** Contours, feature edges, suggestive contours and the hierarchy of outlines, as in shaders/outlines. */
import { ACCENT_STEPS, OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import { clamp01, combined, cross, dot, lengthOf, mix, normalize, smoothstep, type Vec3 } from '../../look/vectors.js';

const { LIT, SHADED, INSIDE, LOST_RANGE, LOST_TAPER, LOST_WEIGHT, LIFT_SHARE, MOST_RISE, EDGE_SLOPE } =
  OUTLINE_CONSTANTS;
const { BEGINS_AS_PAPER, IS_PAPER } = OUTLINE_CONSTANTS;
const { STRAY_ACROSS, ACROSS_BENT, ACROSS_BEND, STRAY_UP, UP_BENT, UP_BEND, UP_PHASE } = OUTLINE_CONSTANTS;
const { CROWDED_SHARE, LEAST_WIDTH, LOOKED_BESIDE, ROUNDING, STRAY_FINELY, FINE_PHASE, STRAY_SHARES } =
  OUTLINE_CONSTANTS;

/** Weight of a contour by the curvature of the surface along the line of sight: it ends in a cusp. */
export const taperAt = (bend: number, taper: number): number =>
  taper > 0 ? smoothstep(0, taper, bend) : Number(bend >= 0);

/**
 * The part of an edge, as shares from start to end, where one side faces the eye and the other does not; null if there is none.
 *
 * @param left and `right`: n·v of the two sides at the start and at the end
 */
export function contourAlong(
  left: readonly [number, number],
  right: readonly [number, number],
): readonly [number, number] | null {
  const startsOn = left[0] * right[0] < 0;
  const endsOn = left[1] * right[1] < 0;
  const turnOf = (side: readonly [number, number]) => (side[0] * side[1] < 0 ? side[0] / (side[0] - side[1]) : -1);
  const [leftTurn, rightTurn] = [turnOf(left), turnOf(right)];
  if (startsOn && endsOn) return [0, 1];
  const turn = Math.max(leftTurn, rightTurn);
  if (startsOn) return 0 < turn ? [0, turn] : null;
  if (endsOn) return turn < 1 ? [turn, 1] : null;
  const least = Math.min(leftTurn, rightTurn);
  return least >= 0 && least < turn ? [least, turn] : null;
}

/**
 * Half of the greatest width where lines crowd.
 *
 * @param spacing the distance between them, pixels
 * @param width of an outline of weight 1, pixels
 * @param pen the width of all lines, pixels: none is thinner. 0 where they have widths of their own
 */
export function crowdedHalf(spacing: number, width: number, pen: number): number {
  const most = CROWDED_SHARE * spacing - LEAST_WIDTH * width;
  return most > 0 && most >= pen ? 0.5 * most : 0;
}

/** The light, the eye, and the effect of light on outlines. Directions are unit, or null vectors for none. */
export interface OutlineLight {
  light: Vec3;
  sight: Vec3;
  shadeWeights: readonly [lit: number, shaded: number];
  lostEdges: number;
}

/**
 * A factor on the weight of an outline, and another one before paper: the share that is left where edges are lost.
 *
 * @param normal unit, in the space of the directions
 * @param contour the share of the piece that is a contour or a border
 */
export function shadeWeight(
  normal: Vec3,
  contour: number,
  { light, sight, shadeWeights, lostEdges }: OutlineLight,
): readonly [weight: number, left: number] {
  const weight = mix(shadeWeights[0], shadeWeights[1], smoothstep(LIT, SHADED, 0.5 - 0.5 * dot(normal, light)));
  const inside = dot(normalize(combined(1, normal, INSIDE, sight)), light);
  const from = 1 - LOST_RANGE * lostEdges;
  const taper = LOST_TAPER[0] + LOST_TAPER[1] * lostEdges;
  const lost = LOST_WEIGHT[0] + LOST_WEIGHT[1] * lostEdges;
  return [weight, 1 - contour * lost * smoothstep(from, from + taper, inside)];
}

/** The properties of a piece of outline that its visibility depends on. Lengths in world units. */
export interface LiftedPiece {
  /** Whether it lies on a surface, not on an edge. */
  isSmooth: boolean;
  /** Curvature along the line of sight times the bounding radius. */
  bend: number;
  /** Depth of the surface beside the piece along the line of sight. */
  extent: number;
  /** The part of that depth that may lie before a visible piece. */
  ownCover: number;
  /** Whether it is a concave edge. */
  isValley: boolean;
}

/** Distance by which an outline is moved towards the eye, so that its own surface does not hide it. radius: of the bounding sphere. */
export function liftOf({ isSmooth, bend, extent }: LiftedPiece, halfWidth: number, radius: number): number {
  const own = LIFT_SHARE * radius + extent;
  if (!isSmooth) return own + 2 * EDGE_SLOPE * halfWidth;
  const rise = Math.sqrt((2 * halfWidth * radius) / Math.max(bend, 1e-3));
  return own + 2 * halfWidth + Math.min(rise, MOST_RISE * radius);
}

/** Distance by which the surface may lie before its own outline. pixel: its size; radius: of the bounding sphere. */
export const toleranceOf = ({ ownCover, isValley }: LiftedPiece, pixel: number, radius: number): number =>
  ROUNDING * radius + ownCover + (isValley ? LOOKED_BESIDE * EDGE_SLOPE * pixel : 0);

/** 1 if what lies so far behind an outline, as a share of the height of the view, counts as paper. */
export const paperness = (gap: number): number => smoothstep(BEGINS_AS_PAPER, IS_PAPER, clamp01(gap));

/** The unsteadiness of a hand: a slow screen-space offset that is fixed to the object. p: position over the bounding radius. */
export function wobbleAt(p: Vec3, wobble: number): readonly [number, number] {
  const a = Math.sin(dot(p, STRAY_ACROSS) + ACROSS_BEND * Math.sin(dot(p, ACROSS_BENT)));
  const b = Math.sin(dot(p, STRAY_UP) + UP_BEND * Math.sin(dot(p, UP_BENT)) + UP_PHASE);
  const c = Math.sin(dot(p, STRAY_FINELY) + FINE_PHASE);
  const [long, short] = STRAY_SHARES;
  return [wobble * (long * a + short * c), wobble * (long * b - short * c)];
}

/** Whether a triangle faces away though its normals do not, so that its neighbours hide it. */
export function looksAway(
  corners: readonly [Vec3, Vec3, Vec3],
  normals: readonly [Vec3, Vec3, Vec3],
  toEye: Vec3,
): boolean {
  const flat = cross(combined(1, corners[1], -1, corners[0]), combined(1, corners[2], -1, corners[0]));
  const smooth = combined(1, combined(1, normals[0], 1, normals[1]), 1, normals[2]);
  return dot(flat, toEye) * dot(flat, smooth) <= 0;
}

/** The depth of a triangle across a piece of contour on it, along the line of sight. */
export function depthAcross(corners: readonly [Vec3, Vec3, Vec3], start: Vec3, end: Vec3, toEye: Vec3): number {
  const v = normalize(toEye);
  const along = normalize(combined(1, end, -1, start));
  const sideways = combined(1, v, -dot(v, along), along);
  const depths = corners.map((corner) => dot(combined(1, corner, -1, corners[0]), sideways));
  return lengthOf(sideways) === 0 ? 0 : Math.max(...depths) - Math.min(...depths);
}

const { ACCENT_REACH, LEAST_JUMP, FULL_JUMP } = OUTLINE_CONSTANTS;

/** Distance between steps, in the unit of the width. */
export const strideOf = (outlineWidth: number): number => (ACCENT_REACH * outlineWidth) / ACCENT_STEPS;

/** The line weight of an outline. */
export interface LineWeight {
  /** The share of paper in what lies behind. */
  paper: number;
  /** 1 where another outline begins, 0 where none is near. */
  accent: number;
}

/**
 * The line weight at a place. Along the outline it changes gradually with what lies behind it, and an accent grows towards such a
 * change.
 *
 * @param here distance from the outline back to the surface beside it, in heights of the view, up to 1
 * @param gapAt the same distance at a step along the outline, in either direction; undefined beyond the picture
 */
export function lineWeightAt(here: number, gapAt: (step: number) => number | undefined): LineWeight {
  let paper = paperness(here);
  let sum = 1;
  let accent = 0;
  for (const side of [-1, 1]) {
    let last = here;
    for (let i = 1; i <= ACCENT_STEPS; i++) {
      const gap = gapAt(side * i);
      if (gap === undefined || Math.min(gap, last) < LEAST_JUMP) break;
      const nearness = 1 - (i - 0.5) / ACCENT_STEPS;
      accent = Math.max(accent, nearness * smoothstep(LEAST_JUMP, FULL_JUMP, Math.abs(gap - last)));
      paper += nearness * paperness(gap);
      sum += nearness;
      last = gap;
    }
  }
  return { paper: paper / sum, accent };
}

const { LEAST_GROWTH, FULL_GROWTH, LEAST_LEAN, FULL_LEAN } = OUTLINE_CONSTANTS;

/** A corner of a triangle with a suggestive contour, where a contour would appear if the eye moved a little. */
export interface BentCorner {
  position: Vec3;
  /** Unit. */
  normal: Vec3;
  /** Curvature along the line of sight, times the radius. */
  bend: number;
}

/**
 * The share of its weight that the outline on a triangle has, from 0 to 1.
 *
 * @param toEye from the middle of the triangle, of any length
 * @param radius of the bounding sphere, in the unit of the positions
 */
export function suggestiveShare(
  corners: readonly [BentCorner, BentCorner, BentCorner],
  toEye: Vec3,
  radius: number,
): number {
  const [a, b, c] = corners;
  const ab = combined(1, b.position, -1, a.position);
  const ac = combined(1, c.position, -1, a.position);
  const n = cross(ab, ac);
  // The gradient of the curvature, which is linear over the triangle.
  const rising = cross(n, combined(c.bend - a.bend, ab, -(b.bend - a.bend), ac));
  const gradient = combined(1 / Math.max(dot(n, n), 1e-30), rising, 0, rising);
  const normal = normalize(combined(1, combined(1, a.normal, 1, b.normal), 1, c.normal));
  const v = normalize(toEye);
  const w = combined(1, v, -dot(normal, v), normal);
  const lean = lengthOf(w);
  const growth = (radius * dot(gradient, w)) / Math.max(lean, 1e-6);
  return smoothstep(LEAST_GROWTH, FULL_GROWTH, growth * smoothstep(LEAST_LEAN, FULL_LEAN, lean));
}
