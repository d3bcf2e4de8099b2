import { disjointSets, join, rootOf } from '../disjointSets.js';
import { hashWords } from '../hashWords.js';
import { forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { weldPositions } from '../weldPositions.js';

/** The bodies of a mesh, each named by one of its vertices: what is connected by vertices at the same positions. */
export interface Bodies {
  /** The body of each triangle. */
  ofTriangles: Uint32Array;
  /** For each body the sum of hashes of its directed edges, which those of their reverses cancel: 0 if it is closed. */
  edges: Int32Array;
  /** Six times the volume that each body encloses. */
  volumes: Float64Array;
}

/**
 * Finds the triangles whose inside can be seen from somewhere: those of bodies that are open, and of bodies that face inward. A body is
 * closed if each of its edges occurs as often in one direction as in the other.
 *
 * @returns for each triangle 1 if it is open
 */
export function* openTriangles(mesh: TriangleMesh): Generator<number, Uint8Array<ArrayBuffer>, void> {
  const { canonical } = yield* weldPositions(mesh.positions);
  const { ofTriangles, edges, volumes } = yield* measureBodies(mesh, canonical);
  return Uint8Array.from(ofTriangles, (body) => (edges[body] !== 0 || volumes[body] < 0 ? 1 : 0));
}

/** Finds the bodies of a mesh. @param canonical for each vertex the first one at its position */
export function* measureBodies(mesh: TriangleMesh, canonical: Uint32Array): Generator<number, Bodies, void> {
  const { positions, indices } = mesh;
  const triangles = indices.length / 3;
  const vertices = positions.length / 3;
  const parents = disjointSets(vertices);
  yield* forEachChunk(triangles, (start, end) => joinTriangles(mesh, canonical, parents, start, end));
  const bodies: Bodies = {
    ofTriangles: Uint32Array.from({ length: triangles }, (_, i) => rootOf(parents, canonical[indices[3 * i]])),
    edges: new Int32Array(vertices),
    volumes: new Float64Array(vertices),
  };
  yield* forEachChunk(triangles, (start, end) => measureTriangles(mesh, canonical, bodies, start, end));
  return bodies;
}

function joinTriangles(
  { indices }: TriangleMesh,
  canonical: Uint32Array,
  parents: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = 3 * start; corner < 3 * end; corner += 3) {
    join(parents, canonical[indices[corner]], canonical[indices[corner + 1]]);
    join(parents, canonical[indices[corner]], canonical[indices[corner + 2]]);
  }
}

function measureTriangles(
  { positions, indices }: TriangleMesh,
  canonical: Uint32Array,
  { ofTriangles, edges, volumes }: Bodies,
  start: number,
  end: number,
): void {
  for (let corner = 3 * start; corner < 3 * end; corner += 3) {
    const a = canonical[indices[corner]];
    const b = canonical[indices[corner + 1]];
    const c = canonical[indices[corner + 2]];
    const body = ofTriangles[corner / 3];
    edges[body] += directed(a, b) + directed(b, c) + directed(c, a);
    volumes[body] += pyramid(positions, 3 * body, 3 * a, 3 * b, 3 * c);
  }
}

/** A hash of a directed edge; that of its reverse is its negative. */
const directed = (from: number, to: number): number => (hashWords(from, to, 0) - hashWords(to, from, 0)) | 0;

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
