/** 3 × 3 matrices, for functions that WGSL lacks. */
import { tsl, type Value } from './values.js';

const { cross, dot, mat3, select, transpose, vec3 } = tsl;

/** The linear part of a 4 × 4 matrix. */
export const linearPart = (matrix: Value): Value =>
  mat3(...[0, 1, 2].map((column) => matrix.element(column).xyz)).toVar();

/** The inverse of a matrix. @param otherwise the result for a singular matrix */
export function inverseOf(matrix: Value, otherwise: Value | null = null): Value {
  const [x, y, z] = [0, 1, 2].map((column) => vec3(matrix.element(column)).toVar());
  const yz = cross(y, z).toVar();
  const determinant = dot(x, yz).toVar();
  const rows = [yz, cross(z, x), cross(x, y)].map((row) => row.div(determinant));
  const inverse = transpose(mat3(...rows)).toVar();
  if (!otherwise) return inverse;
  const isNone = determinant.equal(0).toVar();
  return mat3(...[0, 1, 2].map((column) => select(isNone, otherwise.element(column), inverse.element(column)))).toVar();
}

export const identity = (): Value => mat3(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1));
