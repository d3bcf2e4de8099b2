/**
 * Transforms points to world space.
 *
 * @param matrix the elements of the matrix, by columns
 */
export function toWorldPoints(points: Float32Array, matrix: readonly number[]): Float32Array<ArrayBuffer> {
  const [m0, m1, m2, , m4, m5, m6, , m8, m9, m10, , m12, m13, m14] = matrix;
  const moved = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i];
    const y = points[i + 1];
    const z = points[i + 2];
    moved[i] = m0 * x + m4 * y + m8 * z + m12;
    moved[i + 1] = m1 * x + m5 * y + m9 * z + m13;
    moved[i + 2] = m2 * x + m6 * y + m10 * z + m14;
  }
  return moved;
}

/**
 * Transforms normals to unit normals in world space. A normal without direction becomes zero.
 *
 * @param sign −1 reverses the normals
 */
export function toWorldNormals(
  normals: Float32Array,
  matrix: readonly number[],
  sign: number,
): Float32Array<ArrayBuffer> {
  const [a, b, c, , d, e, f, , g, h, i] = matrix;
  // The cofactors are the inverse transpose times the determinant, of which only the sign matters.
  const turn = sign * Math.sign(a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e));
  const cofactors = [
    e * i - f * h,
    c * h - b * i,
    b * f - c * e,
    f * g - d * i,
    a * i - c * g,
    c * d - a * f,
    d * h - e * g,
    b * g - a * h,
    a * e - b * d,
  ];
  const turned = new Float32Array(normals.length);
  for (let k = 0; k < normals.length; k += 3) {
    const x = normals[k];
    const y = normals[k + 1];
    const z = normals[k + 2];
    const u = cofactors[0] * x + cofactors[1] * y + cofactors[2] * z;
    const v = cofactors[3] * x + cofactors[4] * y + cofactors[5] * z;
    const w = cofactors[6] * x + cofactors[7] * y + cofactors[8] * z;
    const length = Math.hypot(u, v, w);
    if (!(length > 0 && length < Infinity)) continue;
    turned[k] = (turn * u) / length;
    turned[k + 1] = (turn * v) / length;
    turned[k + 2] = (turn * w) / length;
  }
  return turned;
}
