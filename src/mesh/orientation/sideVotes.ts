import { type Bounds, measureBounds } from '../measureBounds.js';
import { EDGE, mapAxes, project, projectionOf } from '../parallelProjection.js';
import { asPhase, forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { NO_PATCH, type Patches } from './consistentPatches.js';
import type { Part } from './measureParts.js';

/** Pixels to a side of a map of nearest triangles. */
const SIZE = 128;
/** Pairs of opposite directions that a mesh is seen from. */
const PAIRS = 8;
/** Fewer pairs are enough if they agree. */
const LEAST_PAIRS = 3;
/** A patch is clear if one of its sides has no more than this share of the votes for the other, which are at least so many. */
const CLEAR = 0.2;
const CLEAR_VOTES = 32;
/** The share of the area of open patches that must be clear. */
const CLEAR_AREA = 0.999;
/** The least cosine between a triangle's normal and a direction with which its side is told. */
const LEAST_COSINE = 0.1;
const NO_TRIANGLE = -1;

/** How many pixels show the front of each patch, and how many its back, from all directions; of patches that fill none, how many samples. */
export interface SideVotes {
  front: Float64Array;
  back: Float64Array;
}

/** Of patches with fewer pixels samples count. */
const LEAST_PIXELS = 4;
/** How far behind the nearest surface a sample may lie to be seen, in pixels. */
const LIFT = 0.5;
/** A sample that is seen from a lesser share of the directions lies in a gap. */
const LEAST_SEEN = 0.1;

/** The two maps of a pair of directions. */
interface NearestMaps {
  /** For each pixel the depth and the triangle that are seen from the first direction, then those from the opposite one. */
  depths: [Float32Array, Float32Array];
  triangles: [Int32Array, Int32Array];
  /** x, y in pixels and depth of each vertex. */
  projected: Float32Array;
}

/**
 * Counts from which side patches are seen, from up to 16 directions around the mesh. The front of a triangle is where its corners run
 * counterclockwise after those in `turned` were turned.
 */
export function* sideVotes(
  mesh: TriangleMesh,
  patches: Patches,
  parts: readonly Part[],
): Generator<number, SideVotes, void> {
  const { positions, indices } = mesh;
  const count = patches.isClosed.length;
  const pixels = SIZE * SIZE;
  const maps: NearestMaps = {
    depths: [new Float32Array(pixels), new Float32Array(pixels)],
    triangles: [new Int32Array(pixels), new Int32Array(pixels)],
    projected: new Float32Array(positions.length),
  };
  const { min, max, radius } = yield* measureBounds(mesh);
  const center: Bounds['min'] = [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1]), 0.5 * (min[2] + max[2])];
  const scale = SIZE / (2 * radius);
  const votes = noVotes(count);
  const ofSamples = noVotes(count);
  for (let pair = 0; pair < PAIRS; pair++) {
    const projection = projectionOf(mapAxes(pair), { center, radius }, SIZE);
    for (const map of maps.triangles) map.fill(NO_TRIANGLE);
    maps.depths[0].fill(-Infinity);
    maps.depths[1].fill(Infinity);
    project(positions, maps.projected, projection, 0, positions.length / 3);
    yield* asPhase(
      forEachChunk(indices.length / 3, (start, end) => drawNearest(maps, indices, patches, 1e-5 * radius, start, end)),
      pair / PAIRS,
      (pair + 1) / PAIRS,
    );
    countVotes(maps, indices, patches, scale, votes);
    for (const { isClosed, samples } of parts) {
      if (isClosed) continue;
      for (const triangle of samples) countSample(maps, indices, patches, scale, triangle, ofSamples);
    }
    if (pair + 1 >= LEAST_PAIRS && areClear(votes, parts)) break;
  }
  for (const [patch, { samples }] of parts.entries()) {
    const seen = ofSamples.front[patch] + ofSamples.back[patch];
    if (votes.front[patch] + votes.back[patch] >= LEAST_PIXELS) continue;
    if (seen < LEAST_SEEN * 2 * PAIRS * samples.length) continue;
    votes.front[patch] = ofSamples.front[patch];
    votes.back[patch] = ofSamples.back[patch];
  }
  return votes;
}

/** Whether further votes would change nothing. */
function areClear({ front, back }: SideVotes, parts: readonly Part[]): boolean {
  let all = 0;
  let clear = 0;
  for (const [patch, { isClosed, doubleArea }] of parts.entries()) {
    if (isClosed) continue;
    all += doubleArea;
    const most = Math.max(front[patch], back[patch]);
    if (most >= CLEAR_VOTES && Math.min(front[patch], back[patch]) <= CLEAR * most) clear += doubleArea;
  }
  return clear >= CLEAR_AREA * all;
}

const noVotes = (count: number): SideVotes => ({ front: new Float64Array(count), back: new Float64Array(count) });

/** Counts from which of the two directions the middle of a triangle is seen. */
function countSample(
  { depths: [highest, lowest], projected }: NearestMaps,
  indices: Uint32Array,
  { turned, patchOf }: Patches,
  scale: number,
  triangle: number,
  { front, back }: SideVotes,
): void {
  const area = signedArea(projected, indices, turned, triangle);
  if (Math.abs(area) < LEAST_COSINE * doubleAreaOf(projected, indices, triangle, scale)) return;
  const [x, y, depth] = [0, 1, 2].map(
    (k) =>
      (projected[3 * indices[3 * triangle] + k] +
        projected[3 * indices[3 * triangle + 1] + k] +
        projected[3 * indices[3 * triangle + 2] + k]) /
      3,
  );
  const pixel = Math.floor(y) * SIZE + Math.floor(x);
  const tolerance = LIFT / scale;
  const patch = patchOf[triangle];
  if (!(highest[pixel] > depth + tolerance)) (area > 0 ? front : back)[patch]++;
  if (!(lowest[pixel] < depth - tolerance)) (area > 0 ? back : front)[patch]++;
}

/** Twice the signed area of a projected triangle in square pixels: positive if its front faces the first direction. */
function signedArea(projected: Float32Array, indices: Uint32Array, turned: Uint8Array, triangle: number): number {
  const a = 3 * indices[3 * triangle];
  const b = 3 * indices[3 * triangle + 1];
  const c = 3 * indices[3 * triangle + 2];
  const area =
    (projected[b] - projected[a]) * (projected[c + 1] - projected[a + 1]) -
    (projected[c] - projected[a]) * (projected[b + 1] - projected[a + 1]);
  return turned[triangle] ? -area : area;
}

/** @param tolerance depths that differ by less are alike: of two triangles there, the one that shows its front is taken */
function drawNearest(
  { depths: [highest, lowest], triangles: [top, bottom], projected }: NearestMaps,
  indices: Uint32Array,
  { turned, patchOf }: Patches,
  tolerance: number,
  start: number,
  end: number,
): void {
  const edge = EDGE;
  const most = 1 - edge;
  for (let triangle = start; triangle < end; triangle++) {
    if (patchOf[triangle] === NO_PATCH) continue;
    const a = 3 * indices[3 * triangle];
    const b = 3 * indices[3 * triangle + 1];
    const c = 3 * indices[3 * triangle + 2];
    const ax = projected[a];
    const ay = projected[a + 1];
    const bx = projected[b] - ax;
    const by = projected[b + 1] - ay;
    const cx = projected[c] - ax;
    const cy = projected[c + 1] - ay;
    // Everything lies on the map, so that truncation rounds down.
    const left = (ax + (bx < cx ? (bx < 0 ? bx : 0) : cx < 0 ? cx : 0) + 0.5) | 0;
    const right = (ax + (bx > cx ? (bx > 0 ? bx : 0) : cx > 0 ? cx : 0) - 0.5) | 0;
    if (left > right) continue;
    const low = (ay + (by < cy ? (by < 0 ? by : 0) : cy < 0 ? cy : 0) + 0.5) | 0;
    const high = (ay + (by > cy ? (by > 0 ? by : 0) : cy > 0 ? cy : 0) - 0.5) | 0;
    if (low > high) continue;
    const area = bx * cy - by * cx;
    if (area === 0) continue;
    const showsFront = area > 0 !== (turned[triangle] === 1);
    const bias = showsFront ? -tolerance : tolerance;
    const az = projected[a + 2];
    const bz = projected[b + 2] - az;
    const cz = projected[c + 2] - az;
    // The barycentric weights of b and c at the middle of the first pixel, and how they change to the right and upwards.
    const perArea = 1 / area;
    const rightB = cy * perArea;
    const rightC = -by * perArea;
    const upB = -cx * perArea;
    const upC = bx * perArea;
    const px = left + 0.5 - ax;
    const py = low + 0.5 - ay;
    let rowB = px * rightB + py * upB;
    let rowC = px * rightC + py * upC;
    const width = right - left;
    for (let row = low * SIZE + left; row <= high * SIZE + left; row += SIZE) {
      let shareB = rowB;
      let shareC = rowC;
      for (let pixel = row; pixel <= row + width; pixel++) {
        if (shareB >= edge && shareC >= edge && shareB + shareC <= most) {
          const depth = az + shareB * bz + shareC * cz;
          if (depth > highest[pixel] + bias) {
            highest[pixel] = depth;
            top[pixel] = triangle;
          }
          if (depth < lowest[pixel] + bias) {
            lowest[pixel] = depth;
            bottom[pixel] = triangle;
          }
        }
        shareB += rightB;
        shareC += rightC;
      }
      rowB += upB;
      rowC += upC;
    }
  }
}

function countVotes(
  { triangles, projected }: NearestMaps,
  indices: Uint32Array,
  { turned, patchOf }: Patches,
  scale: number,
  { front, back }: SideVotes,
): void {
  for (const [i, map] of triangles.entries()) {
    for (const triangle of map) {
      if (triangle === NO_TRIANGLE) continue;
      const area = signedArea(projected, indices, turned, triangle);
      if (Math.abs(area) < LEAST_COSINE * doubleAreaOf(projected, indices, triangle, scale)) continue;
      const isFront = i === 0 ? area > 0 : area < 0;
      (isFront ? front : back)[patchOf[triangle]]++;
    }
  }
}

/** Twice the area of a triangle, in square pixels. */
function doubleAreaOf(projected: Float32Array, indices: Uint32Array, triangle: number, scale: number): number {
  const [a, b, c] = [0, 1, 2].map((k) => 3 * indices[3 * triangle + k]);
  const side = (end: number): [number, number, number] => [
    projected[end] - projected[a],
    projected[end + 1] - projected[a + 1],
    scale * (projected[end + 2] - projected[a + 2]),
  ];
  const [ux, uy, uz] = side(b);
  const [vx, vy, vz] = side(c);
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
}
