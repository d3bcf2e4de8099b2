import { isFan, triangulatePolygon } from './triangulatePolygon.js';

/**
 * Replaces the triangles of polygons that were read as fans, so that notches stay open. As many triangles stay: those that are not needed have no
 * area, and are left out later.
 *
 * @param positions xyz of the vertices
 * @param indices of the triangles, of which those of the polygons are overwritten
 * @param polygons for each, where its triangles begin in `indices`, and where they end
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
