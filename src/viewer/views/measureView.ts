import { MAP_SIZE, NOTHING, type SeenMap, type Vector } from './seenMap.js';
import type { ViewSurface } from './viewSurface.js';

/** What is measured of a view, each independent of how the surface is divided into triangles. */
export interface ViewMeasures {
  /** The share of the surface that is seen. */
  visibility: number;
  /** The share of the map that the surface covers. */
  cover: number;
  /** The length of the silhouette, in map sides. */
  outline: number;
  /** The standard deviation of depth, in radii. */
  depth: number;
  /** How far the surface bends inwards along its rows and columns: eyes, folds and joints, but no smooth back. */
  relief: number;
  /** The length of the outlines within the silhouette, in map sides. */
  inner: number;
  /** The entropy of the directions that the seen surface faces. */
  sides: number;
  /** The share of the seen surface that shows its back. */
  backs: number;
  /** The share of what is seen that slopes and faces upwards. */
  slopes: number;
  /** How much nearer than the middle of the unit sphere the seen surface lies, in radii. */
  near: number;
}

/** Steps of depth between neighbouring pixels beyond which one surface hides another, in pixels. */
const STEP = 3;
/** The least cosine by which a pixel's area is divided. */
const LEAST_COSINE = 0.2;
/** Directions are sorted into this many cells to a unit. */
const CELLS = 2;
/** What slopes faces upwards by more than the first and less than the second sine. */
const SLOPE = { least: 0.15, most: 0.95 };
const CELLS_ACROSS = 2 * CELLS + 1;

/** Sums over the pixels of a map that show a triangle. */
interface Sums {
  covered: number;
  seen: number;
  backs: number;
  slopes: number;
  outline: number;
  inner: number;
  relief: number;
  nearness: number;
  squares: number;
}

/** Measures what a map shows of its surface. */
export function measureView(map: SeenMap, { normals, area }: ViewSurface): ViewMeasures {
  const pixel = 2 / MAP_SIZE;
  const histogram = new Float64Array(CELLS_ACROSS ** 3);
  const sums = { covered: 0, seen: 0, backs: 0, slopes: 0, outline: 0, inner: 0, relief: 0, nearness: 0, squares: 0 };
  for (let row = 0; row < MAP_SIZE; row++) addRow(sums, histogram, map, normals, row * MAP_SIZE);
  const { covered, outline, inner, relief } = sums;
  const count = Math.max(1, covered);
  const mean = sums.nearness / count;
  return {
    visibility: Math.min(1, (sums.seen * pixel ** 2) / area),
    cover: covered / MAP_SIZE ** 2,
    outline: outline / MAP_SIZE,
    depth: Math.sqrt(Math.max(0, sums.squares / count - mean ** 2)) * pixel,
    relief: relief / MAP_SIZE,
    inner: inner / MAP_SIZE,
    sides: histogram.reduce((sum, cell) => (cell > 0 ? sum - (cell / count) * Math.log(cell / count) : sum), 0),
    backs: sums.backs / count,
    slopes: sums.slopes / count,
    near: mean * pixel,
  };
}

/** Adds a row of pixels to the sums. It is a function of its own, since a short one that is called often is compiled once. */
function addRow(
  sums: Sums,
  histogram: Float64Array,
  { triangles, nearness, towards, right, up }: SeenMap,
  normals: Float32Array,
  start: number,
): void {
  const tx = towards[0];
  const ty = towards[1];
  const tz = towards[2];
  const last = start + MAP_SIZE - 1;
  for (let at = start; at <= last; at++) {
    const triangle = triangles[at];
    if (triangle === NOTHING) continue;
    const near = nearness[at];
    const n = 3 * triangle;
    const facing = normals[n] * tx + normals[n + 1] * ty + normals[n + 2] * tz;
    const sign = facing < 0 ? -1 : 1;
    const x = sign * normals[n];
    const y = sign * normals[n + 1];
    const z = sign * normals[n + 2];
    sums.covered++;
    sums.seen += 1 / Math.max(LEAST_COSINE, sign * facing);
    if (facing < 0) sums.backs++;
    if (y > SLOPE.least && y < SLOPE.most) sums.slopes++;
    sums.nearness += near;
    sums.squares += near * near;
    histogram[(cellOf(x) * CELLS_ACROSS + cellOf(y)) * CELLS_ACROSS + cellOf(z)]++;
    if (at === start || triangles[at - 1] === NOTHING) sums.outline++;
    if (start === 0 || triangles[at - MAP_SIZE] === NOTHING) sums.outline++;
    const beside = at < last ? triangles[at + 1] : NOTHING;
    if (beside === NOTHING) sums.outline++;
    else addBend(sums, normals, triangle, beside, nearness[at + 1] - near, towards, right);
    const above = at + MAP_SIZE < triangles.length ? triangles[at + MAP_SIZE] : NOTHING;
    if (above === NOTHING) sums.outline++;
    else addBend(sums, normals, triangle, above, nearness[at + MAP_SIZE] - near, towards, up);
  }
}

/** The cell of a coordinate of a unit vector. */
const cellOf = (coordinate: number): number => Math.round(CELLS * (1 + coordinate));

/** Adds an outline within the silhouette between neighbouring pixels, or about the angle by which the surface bends inwards there. */
function addBend(
  sums: Sums,
  normals: Float32Array,
  triangle: number,
  other: number,
  rise: number,
  towards: Vector,
  across: Vector,
): void {
  if (Math.abs(rise) > STEP) sums.inner++;
  if (Math.abs(rise) > STEP || other === triangle) return;
  const a = 3 * triangle;
  const b = 3 * other;
  const facingA = normals[a] * towards[0] + normals[a + 1] * towards[1] + normals[a + 2] * towards[2];
  const facingB = normals[b] * towards[0] + normals[b + 1] * towards[1] + normals[b + 2] * towards[2];
  const acrossA = normals[a] * across[0] + normals[a + 1] * across[1] + normals[a + 2] * across[2];
  const acrossB = normals[b] * across[0] + normals[b + 1] * across[1] + normals[b + 2] * across[2];
  const signA = facingA < 0 ? -1 : 1;
  const signB = facingB < 0 ? -1 : 1;
  if (signB * (acrossB + rise * facingB) >= signA * (acrossA + rise * facingA)) return;
  const cosine = normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
  // The chord is nearly the angle, and much cheaper.
  sums.relief += Math.sqrt(Math.max(0, 2 - 2 * signA * signB * cosine));
}
