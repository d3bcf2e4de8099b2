import { combined, cross, normalize, type Vec3 } from '../../look/vectors.js';
import { type LineSurface, STRIDE, TONE_NORMAL, WORLD } from '../LineSurface.js';

/** Corners per step, of whole triangles. */
const CHUNK = 3 * 1024;

/** A surface with flat shading: each triangle gets vertices of its own with its normal. Yields meanwhile. */
export function* flattened(surface: LineSurface): Generator<number, LineSurface, void> {
  const { vertices, triangles, placeOf, details } = surface;
  const flat: LineSurface = {
    ...surface,
    vertices: new Float64Array(STRIDE * triangles.length),
    placeOf: triangles.map((vertex) => placeOf[vertex]),
    triangles: triangles.map((_, corner) => corner),
  };
  for (const [corner, vertex] of triangles.entries()) {
    if (corner % CHUNK === 0) yield 1;
    flat.vertices.set(vertices.subarray(STRIDE * vertex, STRIDE * (vertex + 1)), STRIDE * corner);
  }
  const placeAt = (corner: number): Vec3 => {
    const o = STRIDE * corner + WORLD;
    return [flat.vertices[o], flat.vertices[o + 1], flat.vertices[o + 2]];
  };
  for (let corner = 0; corner < triangles.length; corner += 3) {
    if (corner % CHUNK === 0) yield 1;
    const [a, b, c] = [placeAt(corner), placeAt(corner + 1), placeAt(corner + 2)];
    const normal = normalize(cross(combined(1, b, -1, a), combined(1, c, -1, a)));
    for (let k = 0; k < 3; k++)
      for (let axis = 0; axis < 3; axis++) flat.vertices[STRIDE * (corner + k) + TONE_NORMAL + axis] = normal[axis];
  }
  if (!details) return flat;
  const { stride } = details;
  const numbers = new Float64Array(stride * triangles.length);
  for (const [corner, vertex] of triangles.entries()) {
    if (corner % CHUNK === 0) yield 1;
    for (let i = 0; i < stride; i++) numbers[stride * corner + i] = details.numbers[stride * vertex + i];
  }
  return { ...flat, details: { ...details, corners: flat.triangles, numbers } };
}
