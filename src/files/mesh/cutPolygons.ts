import { triangulatePolygon } from './triangulatePolygon.js';

/**
 * Replaces the triangles of polygons that were read as fans, so that notches stay open. As many triangles stay: those that are not needed have no
 * area, and are left out later.
 *
 * @param positions xyz of the vertices
 * @param indices of the triangles, of which those of the polygons are overwritten
 * @param polygons for each, where its triangles begin in `indices`, and where they end
 */
export function cutPolygons(positions: ArrayLike<number>, indices: Uint32Array, polygons: readonly number[]): void {
  for (let i = 0; i < polygons.length; i += 2) {
    const fan = indices.subarray(polygons[i], polygons[i + 1]);
    const corners = [fan[0], fan[1]];
    for (let k = 2; k < fan.length; k += 3) corners.push(fan[k]);
    const points = corners.flatMap((vertex) => [0, 1, 2].map((axis) => positions[3 * vertex + axis] ?? NaN));
    const triangles = triangulatePolygon(points);
    for (let k = 0; k < fan.length; k++) fan[k] = corners[triangles[k] ?? 0];
  }
}
