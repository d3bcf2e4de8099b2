import { dot, faceNormal } from './vector.js';

/**
 * The interior edges of a triangle soup, each as seen by both its triangles.
 *
 * @param positions - xyz of the three corners of each triangle, one triangle after the other.
 * @param maximumAngle - edges whose triangles' normals differ by more, in radians, are left out: strokes should break at a crease.
 * @returns four corners per edge: the ends of the edge in one triangle, then the same two points in the other. Border and
 *   non-manifold edges are left out.
 */
export function pairedEdges(positions: ArrayLike<number>, maximumAngle: number): Uint32Array {
  const corners = positions.length / 3;
  const points = new Map<string, number>();
  const pointOf = new Uint32Array(corners);
  for (let corner = 0; corner < corners; corner++) {
    // Adding 0 turns −0 into 0.
    const key = `${positions[3 * corner] + 0},${positions[3 * corner + 1] + 0},${positions[3 * corner + 2] + 0}`;
    const known = points.get(key);
    if (known === undefined) points.set(key, points.size);
    pointOf[corner] = known ?? points.size - 1;
  }

  /** The corners that start the half-edges between two points, in either direction. */
  const halfEdges = new Map<number, number[]>();
  for (let corner = 0; corner < corners; corner++) {
    const [a, b] = [pointOf[corner], pointOf[nextCorner(corner)]];
    const key = Math.min(a, b) * points.size + Math.max(a, b);
    const list = halfEdges.get(key);
    if (list) list.push(corner);
    else halfEdges.set(key, [corner]);
  }

  const paired: number[] = [];
  const least = Math.cos(maximumAngle);
  for (const starts of halfEdges.values()) {
    const [own, twin] = starts;
    if (starts.length !== 2 || own === undefined || twin === undefined) continue;
    const [start, end] = [pointOf[own], pointOf[nextCorner(own)]];
    // The twin runs the other way round, unless the windings contradict each other.
    if (start === end || pointOf[twin] !== end) continue;
    if (!(dot(faceNormal(positions, own), faceNormal(positions, twin)) >= least)) continue;
    paired.push(own, nextCorner(own), nextCorner(twin), twin);
  }
  return Uint32Array.from(paired);
}

const nextCorner = (corner: number) => (corner % 3 === 2 ? corner - 2 : corner + 1);
