import { isFan, triangulatePolygon } from './triangulatePolygon.js';

/**
 * Retriangulates polygons that were read as fans, so that concave ones keep their notches. The number of triangles stays; surplus ones
 * become degenerate and are left out later.
 *
 * @param positions xyz of the vertices
 * @param indices of the triangles; those of the polygons are overwritten
 * @param polygons start and end of each polygon's triangles in `indices`
 */
export function cutPolygons(positions: ArrayLike<number>, indices: Uint32Array, polygons: readonly number[]): void {
  const corners: number[] = [];
  for (let i = 0; i < polygons.length; i += 2) {
    const [start, end] = [polygons[i], polygons[i + 1]];
    corners.length = 0;
    corners.push(indices[start], indices[start + 1]);
    for (let k = start + 2; k < end; k += 3) corners.push(indices[k]);
    if (isFan(positions, corners, corners.length)) continue;
    const points = corners.flatMap((vertex) => [0, 1, 2].map((axis) => positions[3 * vertex + axis] ?? NaN));
    const triangles = triangulatePolygon(points);
    for (let k = start; k < end; k++) indices[k] = corners[triangles[k - start] ?? 0];
  }
}
