import { disjointSets, join, rootOf } from '../disjointSets.js';
import { hashWords } from '../hashWords.js';
import { forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { weldPositions } from '../weldPositions.js';

/**
 * Finds the triangles whose inside can be seen from somewhere: those of bodies that are open, and of bodies that face inward. A body is
 * closed if each of its edges occurs as often in one direction as in the other.
 *
 * @returns for each triangle 1 if it is open
 */
export function* openTriangles(mesh: TriangleMesh): Generator<number, Uint8Array<ArrayBuffer>, void> {
  const { canonical } = yield* weldPositions(mesh.positions);
  const bodyOf = yield* bodiesOf(mesh, canonical);
  const edges = yield* edgeSums(mesh, canonical, bodyOf, canonical.length);
  const volumes = new Float64Array(canonical.length);
  yield* forEachChunk(bodyOf.length, (start, end) => addVolumes(mesh, bodyOf, volumes, start, end));
  return Uint8Array.from(bodyOf, (body) => (edges[body] !== 0 || volumes[body] < 0 ? 1 : 0));
}

/**
 * Finds what is connected by vertices at the same positions.
 *
 * @param canonical for each vertex the first one at its position
 * @returns for each triangle a vertex that names its body
 */
export function* bodiesOf(
  { positions, indices }: TriangleMesh,
  canonical: Uint32Array,
): Generator<number, Uint32Array<ArrayBuffer>, void> {
  const triangles = indices.length / 3;
  const parents = disjointSets(positions.length / 3);
  yield* forEachChunk(triangles, (start, end) => {
    for (let corner = 3 * start; corner < 3 * end; corner += 3) {
      join(parents, canonical[indices[corner]], canonical[indices[corner + 1]]);
      join(parents, canonical[indices[corner]], canonical[indices[corner + 2]]);
    }
  });
  return Uint32Array.from({ length: triangles }, (_, triangle) => rootOf(parents, canonical[indices[3 * triangle]]));
}

/**
 * Sums hashes of the directed edges of groups of triangles, which those of their reverses cancel: 0 for a group that is closed.
 *
 * @param groupOf the group of each triangle; numbers from `count` on are in none
 */
export function* edgeSums(
  { indices }: TriangleMesh,
  canonical: Uint32Array,
  groupOf: Uint32Array,
  count: number,
): Generator<number, Int32Array<ArrayBuffer>, void> {
  const sums = new Int32Array(count);
  yield* forEachChunk(groupOf.length, (start, end) => {
    for (let triangle = start; triangle < end; triangle++) {
      if (groupOf[triangle] >= count) continue;
      const a = canonical[indices[3 * triangle]];
      const b = canonical[indices[3 * triangle + 1]];
      const c = canonical[indices[3 * triangle + 2]];
      sums[groupOf[triangle]] += directed(a, b) + directed(b, c) + directed(c, a);
    }
  });
  return sums;
}

/** A hash of a directed edge; that of its reverse is its negative. */
const directed = (from: number, to: number): number => (hashWords(from, to, 0) - hashWords(to, from, 0)) | 0;

/** Adds six times the volume that each body encloses. */
function addVolumes(
  { positions, indices }: TriangleMesh,
  bodyOf: Uint32Array,
  volumes: Float64Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const [a, b, c] = [3 * indices[3 * triangle], 3 * indices[3 * triangle + 1], 3 * indices[3 * triangle + 2]];
    volumes[bodyOf[triangle]] += pyramid(positions, 3 * bodyOf[triangle], a, b, c);
  }
}

/** Six times the volume between a point and a triangle, by their places in the positions. */
function pyramid(positions: Float32Array, apex: number, a: number, b: number, c: number): number {
  const x = positions[apex];
  const y = positions[apex + 1];
  const z = positions[apex + 2];
  const ax = positions[a] - x;
  const ay = positions[a + 1] - y;
  const az = positions[a + 2] - z;
  const bx = positions[b] - x;
  const by = positions[b + 1] - y;
  const bz = positions[b + 2] - z;
  const cx = positions[c] - x;
  const cy = positions[c + 1] - y;
  const cz = positions[c + 2] - z;
  return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
}
