import { chunkPhase } from './phases.js';
import type { TriangleMesh } from './TriangleMesh.js';

/** The bounding box of a mesh, and the radius of its bounding sphere about the middle of the box. */
export interface Bounds {
  min: [x: number, y: number, z: number];
  max: [x: number, y: number, z: number];
  radius: number;
}

/** Measures the vertices that triangles use, as three.js does: the sphere's centre is the middle of the box. */
export function* measureBounds({ positions, indices }: TriangleMesh): Generator<number, Bounds, void> {
  const bounds: Bounds = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity], radius: 0 };
  const { min, max } = bounds;
  const count = positions.length / 3;
  const isUsed = new Uint8Array(count);
  yield* chunkPhase(indices.length, 0, 0.5, (start, end) => markRange(indices, isUsed, start, end));
  yield* chunkPhase(count, 0.5, 0.8, (start, end) => enclose(positions, isUsed, bounds, start, end));
  const center: Bounds['min'] = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2];
  yield* chunkPhase(count, 0.8, 1, (start, end) => {
    bounds.radius = Math.max(bounds.radius, farthest(positions, isUsed, center, start, end));
  });
  return bounds;
}

/** Marks the vertices of a range of corners. */
function markRange(indices: Uint32Array, isUsed: Uint8Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) isUsed[indices[corner]] = 1;
}

/** Extends the box to the used vertices of a range. */
function enclose(positions: Float32Array, isUsed: Uint8Array, { min, max }: Bounds, start: number, end: number): void {
  let [minX, minY, minZ] = min;
  let [maxX, maxY, maxZ] = max;
  for (let vertex = start; vertex < end; vertex++) {
    if (isUsed[vertex] === 0) continue;
    const i = 3 * vertex;
    const x = positions[i];
    const y = positions[i + 1];
    const z = positions[i + 2];
    minX = Math.min(minX, x);
    minY = Math.min(minY, y);
    minZ = Math.min(minZ, z);
    maxX = Math.max(maxX, x);
    maxY = Math.max(maxY, y);
    maxZ = Math.max(maxZ, z);
  }
  min.splice(0, 3, minX, minY, minZ);
  max.splice(0, 3, maxX, maxY, maxZ);
}

/** The greatest distance from the centre among the used vertices of a range. */
function farthest(
  positions: Float32Array,
  isUsed: Uint8Array,
  [centerX, centerY, centerZ]: Bounds['min'],
  start: number,
  end: number,
): number {
  let square = 0;
  for (let vertex = start; vertex < end; vertex++) {
    if (isUsed[vertex] === 0) continue;
    const i = 3 * vertex;
    const x = positions[i] - centerX;
    const y = positions[i + 1] - centerY;
    const z = positions[i + 2] - centerZ;
    square = Math.max(square, x * x + y * y + z * z);
  }
  return Math.sqrt(square);
}
