import { asPhase, inChunks } from './inChunks.js';
import type { TriangleMesh } from './TriangleMesh.js';

/** The extent of a mesh: its bounding box, and the radius of the sphere about the middle of the box. */
export interface Bounds {
  min: [x: number, y: number, z: number];
  max: [x: number, y: number, z: number];
  radius: number;
}

/** Measures the vertices that triangles use, as three.js does: the sphere stands at the middle of the box. */
export function* measureBounds({ positions, indices }: TriangleMesh): Generator<number, Bounds, void> {
  const min: Bounds['min'] = [Infinity, Infinity, Infinity];
  const max: Bounds['max'] = [-Infinity, -Infinity, -Infinity];
  yield* asPhase(
    inChunks(indices.length, (start, end) => {
      let [minX, minY, minZ] = min;
      let [maxX, maxY, maxZ] = max;
      for (let corner = start; corner < end; corner++) {
        const vertex = 3 * indices[corner]!;
        const x = positions[vertex]!;
        const y = positions[vertex + 1]!;
        const z = positions[vertex + 2]!;
        if (x < minX) minX = x;
        if (y < minY) minY = y;
        if (z < minZ) minZ = z;
        if (x > maxX) maxX = x;
        if (y > maxY) maxY = y;
        if (z > maxZ) maxZ = z;
      }
      min.splice(0, 3, minX, minY, minZ);
      max.splice(0, 3, maxX, maxY, maxZ);
    }),
    0,
    0.5,
  );

  const centerX = (min[0] + max[0]) / 2;
  const centerY = (min[1] + max[1]) / 2;
  const centerZ = (min[2] + max[2]) / 2;
  let largest = 0;
  yield* asPhase(
    inChunks(indices.length, (start, end) => {
      for (let corner = start; corner < end; corner++) {
        const vertex = 3 * indices[corner]!;
        const x = positions[vertex]! - centerX;
        const y = positions[vertex + 1]! - centerY;
        const z = positions[vertex + 2]! - centerZ;
        largest = Math.max(largest, x * x + y * y + z * z);
      }
    }),
    0.5,
    1,
  );
  return { min, max, radius: Math.sqrt(largest) };
}
