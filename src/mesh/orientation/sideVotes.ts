import { type Bounds, measureBounds } from '../measureBounds.js';
import { EDGE, mapAxes, project, projectionOf } from '../occlusion/addDirections.js';
import { asPhase, forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { NO_PATCH, type Patches } from './consistentPatches.js';
import type { Part } from './measureParts.js';

/** Pixels to a side of a map of nearest triangles. */
const SIZE = 128;
/** Pairs of opposite directions that a mesh is seen from. */
const PAIRS = 16;
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
 * Counts from which side patches are seen, from 32 directions around the mesh. The front of a triangle is where its corners run
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
    for (const [patch, { samples }] of parts.entries()) {
      if (parts[patch].isClosed) continue;
      for (const triangle of samples) countSample(maps, indices, patches, scale, triangle, ofSamples);
    }
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
    const left = Math.max(0, Math.ceil(ax + Math.min(0, bx, cx) - 0.5));
    const right = Math.min(SIZE - 1, Math.floor(ax + Math.max(0, bx, cx) - 0.5));
    const low = Math.max(0, Math.ceil(ay + Math.min(0, by, cy) - 0.5));
    const high = Math.min(SIZE - 1, Math.floor(ay + Math.max(0, by, cy) - 0.5));
    const area = bx * cy - by * cx;
    if (left > right || low > high || area === 0) continue;
    const showsFront = area > 0 !== (turned[triangle] === 1);
    const az = projected[a + 2];
    const bz = projected[b + 2] - az;
    const cz = projected[c + 2] - az;
    for (let y = low; y <= high; y++) {
      for (let x = left; x <= right; x++) {
        const px = x + 0.5 - ax;
        const py = y + 0.5 - ay;
        const shareB = (px * cy - py * cx) / area;
        const shareC = (py * bx - px * by) / area;
        if (shareB < EDGE || shareC < EDGE || shareB + shareC > 1 - EDGE) continue;
        const depth = az + shareB * bz + shareC * cz;
        const pixel = y * SIZE + x;
        if (depth > highest[pixel] + (showsFront ? -tolerance : tolerance)) {
          highest[pixel] = depth;
          top[pixel] = triangle;
        }
        if (depth < lowest[pixel] + (showsFront ? -tolerance : tolerance)) {
          lowest[pixel] = depth;
          bottom[pixel] = triangle;
        }
      }
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
