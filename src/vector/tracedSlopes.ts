import { type LineSurface, STRIDE, VIEW } from './LineSurface.js';
import type { Projection } from './Projection.js';

/**
 * How much a function changes per pixel across each triangle, as its lines are traced there: straight, and evenly apart. 0 for triangles
 * without an area on the picture.
 *
 * @param values of the function at the vertices
 * @param traced the triangles that have lines, each perhaps several times
 */
export function* tracedSlopes(
  { triangles, vertices }: LineSurface,
  values: Float64Array,
  traced: ArrayLike<number>,
  projection: Projection,
): Generator<number, Float32Array, void> {
  const slopes = new Float32Array(triangles.length / 3);
  const at = (vertex: number) => {
    const o = STRIDE * vertex + VIEW;
    return projection.project(vertices[o], vertices[o + 1], vertices[o + 2]);
  };
  for (let i = 0; i < traced.length; i++) {
    if (i % 2048 === 2047) yield i / traced.length;
    const t = traced[i];
    if (slopes[t] !== 0) continue;
    const [a, b, c] = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]];
    const [ax, ay] = at(a);
    const [bx, by] = at(b);
    const [cx, cy] = at(c);
    const [ux, uy, wx, wy] = [bx - ax, by - ay, cx - ax, cy - ay];
    const area = ux * wy - uy * wx;
    if (area === 0) continue;
    const [du, dw] = [values[b] - values[a], values[c] - values[a]];
    slopes[t] = Math.hypot(du * wy - dw * uy, dw * ux - du * wx) / Math.abs(area);
  }
  return slopes;
}
