import { MAP_SIZE, NOTHING, type SeenMap } from './seenMap.js';
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

/** Measures what a map shows of its surface. */
export function measureView(map: SeenMap, surface: ViewSurface): ViewMeasures {
  const { triangles, nearness, towards } = map;
  const { normals, area } = surface;
  const pixel = 2 / MAP_SIZE;
  const histogram = new Float64Array(CELLS_ACROSS ** 3);
  let [covered, seen, backs, slopes, outline, inner, relief, sum, squares] = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  for (let at = 0; at < triangles.length; at++) {
    const triangle = triangles[at];
    if (triangle === NOTHING) continue;
    covered++;
    const n = 3 * triangle;
    const facing = normals[n] * towards[0] + normals[n + 1] * towards[1] + normals[n + 2] * towards[2];
    const sign = facing < 0 ? -1 : 1;
    seen += 1 / Math.max(LEAST_COSINE, Math.abs(facing));
    if (facing < 0) backs++;
    const upward = sign * normals[n + 1];
    if (upward > SLOPE.least && upward < SLOPE.most) slopes++;
    sum += nearness[at];
    squares += nearness[at] ** 2;
    const cell =
      (Math.round(CELLS * (1 + sign * normals[n])) * CELLS_ACROSS + Math.round(CELLS * (1 + sign * normals[n + 1]))) *
        CELLS_ACROSS +
      Math.round(CELLS * (1 + sign * normals[n + 2]));
    histogram[cell]++;
    const column = at % MAP_SIZE;
    // No list, which would be made anew for each pixel.
    for (let way = 0; way < 2; way++) {
      const beside = column + 1 < MAP_SIZE ? at + 1 : -1;
      const next = way === 0 ? beside : at + MAP_SIZE;
      const other = next >= 0 && next < triangles.length ? triangles[next] : NOTHING;
      if (other === NOTHING) {
        outline++;
        continue;
      }
      if (Math.abs(nearness[next] - nearness[at]) > STEP) inner++;
      else if (other !== triangle) relief += bend(map, surface, at, next);
    }
    if (column === 0 || triangles[at - 1] === NOTHING) outline++;
    if (at < MAP_SIZE || triangles[at - MAP_SIZE] === NOTHING) outline++;
  }
  let sides = 0;
  for (const share of histogram) if (share > 0) sides -= (share / covered) * Math.log(share / covered);
  const mean = covered > 0 ? sum / covered : 0;
  return {
    visibility: covered > 0 ? Math.min(1, (seen * pixel ** 2) / area) : 0,
    cover: covered / MAP_SIZE ** 2,
    outline: outline / MAP_SIZE,
    depth: covered > 0 ? Math.sqrt(Math.max(0, squares / covered - mean ** 2)) * pixel : 0,
    relief: relief / MAP_SIZE,
    inner: inner / MAP_SIZE,
    sides,
    backs: covered > 0 ? backs / covered : 0,
    slopes: covered > 0 ? slopes / covered : 0,
    near: mean * pixel,
  };
}

/** About the angle, in radians, by which the surface bends inwards from a pixel to a neighbour; 0 if it bends outwards. */
function bend(map: SeenMap, { normals }: ViewSurface, at: number, next: number): number {
  const { triangles, nearness, towards, right, up } = map;
  const across = next === at + 1 ? right : up;
  const rise = nearness[next] - nearness[at];
  const a = 3 * triangles[at];
  const b = 3 * triangles[next];
  let facingA = 0;
  let facingB = 0;
  let cosine = 0;
  let alongA = 0;
  let alongB = 0;
  for (let k = 0; k < 3; k++) {
    const step = across[k] + rise * towards[k];
    facingA += normals[a + k] * towards[k];
    facingB += normals[b + k] * towards[k];
    cosine += normals[a + k] * normals[b + k];
    alongA += normals[a + k] * step;
    alongB += normals[b + k] * step;
  }
  const signA = facingA < 0 ? -1 : 1;
  const signB = facingB < 0 ? -1 : 1;
  // The chord is nearly the angle, and much cheaper.
  return signB * alongB < signA * alongA ? Math.sqrt(Math.max(0, 2 - 2 * signA * signB * cosine)) : 0;
}
