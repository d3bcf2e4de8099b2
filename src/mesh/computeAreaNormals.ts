import { forEachChunk } from './phases.js';
import type { TriangleMesh } from './TriangleMesh.js';

/**
 * Computes the area normal of each triangle, (V1 − V0) × (V2 − V0), in double precision. Its direction is the normal, its
 * length twice the area. All three components are exactly 0 if, and only if, the triangle is degenerate: it has two corners
 * at one position, or all three on one line.
 */
export function* computeAreaNormals(mesh: TriangleMesh): Generator<number, Float64Array<ArrayBuffer>, void> {
  const areaNormals = new Float64Array(mesh.indices.length);
  yield* forEachChunk(mesh.indices.length / 3, (start, end) => computeRange(mesh, areaNormals, start, end));
  return areaNormals;
}

/** Whether the triangle is degenerate. */
export const isDegenerate = (areaNormals: Float64Array, triangle: number): boolean =>
  areaNormals[3 * triangle] === 0 && areaNormals[3 * triangle + 1] === 0 && areaNormals[3 * triangle + 2] === 0;

/** The cosine of the angle between the normals of two triangles; NaN where one is degenerate. */
export function cosineBetween(areaNormals: Float64Array, a: number, b: number): number {
  const ax = areaNormals[3 * a];
  const ay = areaNormals[3 * a + 1];
  const az = areaNormals[3 * a + 2];
  const bx = areaNormals[3 * b];
  const by = areaNormals[3 * b + 1];
  const bz = areaNormals[3 * b + 2];
  // Two roots are multiplied, because the product of the squares could overflow.
  const lengths = Math.sqrt(ax * ax + ay * ay + az * az) * Math.sqrt(bx * bx + by * by + bz * bz);
  return (ax * bx + ay * by + az * bz) / lengths;
}

/** Twice the area of the triangle: the length of its area normal. */
export function doubleArea(areaNormals: Float64Array, triangle: number): number {
  const x = areaNormals[3 * triangle];
  const y = areaNormals[3 * triangle + 1];
  const z = areaNormals[3 * triangle + 2];
  return Math.sqrt(x * x + y * y + z * z);
}

function computeRange({ positions, indices }: TriangleMesh, areaNormals: Float64Array, start: number, end: number) {
  for (let corner = 3 * start; corner < 3 * end; corner += 3) {
    const a = 3 * indices[corner];
    const b = 3 * indices[corner + 1];
    const c = 3 * indices[corner + 2];
    const ax = positions[a];
    const ay = positions[a + 1];
    const az = positions[a + 2];
    const ux = positions[b] - ax;
    const uy = positions[b + 1] - ay;
    const uz = positions[b + 2] - az;
    const vx = positions[c] - ax;
    const vy = positions[c + 1] - ay;
    const vz = positions[c + 2] - az;
    areaNormals[corner] = uy * vz - uz * vy;
    areaNormals[corner + 1] = uz * vx - ux * vz;
    areaNormals[corner + 2] = ux * vy - uy * vx;
  }
}
