/** Matrices, and small functions that several chunks share. */
import { type Input, tsl, type Value } from './values.js';

const { clamp, cross, dot, exp, float, inverseSqrt, mat3, max, min, screenCoordinate, screenSize, select } = tsl;
const { step, transpose, vec2, vec3 } = tsl;

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

/** Whether the camera is orthographic: the last row of its projection ends in 1, in WebXR too. */
export const isOrthographic = (): Value => tsl.cameraProjectionMatrix.element(3).element(3).equal(1);

/** The pixel of the render target, counted from the lower left. */
export const pixelFromBelow = (): Value => vec2(screenCoordinate.x, screenSize.y.sub(screenCoordinate.y));

/**
 * Counterpart of shaders/chunks/safeNormalize.glsl: the unit vector, or the direction to the viewer for the null vector that a zero-area
 * triangle has for a normal.
 */
export function safeNormalize(v: Value): Value {
  // Too small to turn any other vector, and large enough for its square not to underflow.
  const any = v.add(vec3(0, 0, 2e-19)).toVar();
  return any.mul(inverseSqrt(dot(any, any))).toVar();
}

/**
 * Counterpart of shaders/chunks/largestComponents.glsl: masks of the largest component of a vector and of the two largest, with ties broken
 * consistently.
 */
export function largestComponents(v: Value): { largest: Value; twoLargest: Value } {
  const greater = step(v.yzx, v.xyz).toVar();
  const less = greater.oneMinus().toVar();
  return { largest: min(greater, less.zxy).toVar(), twoLargest: max(greater, less.zxy).toVar() };
}

/** Counterpart of shaders/chunks/normalDistribution.glsl: Φ, the standard normal distribution, to 2e-4, and its slope. */
export function normalDistribution(g: Value): Value {
  const at = g.toVar();
  const cube = at.mul(at).mul(at);
  const h = float(1)
    .div(exp(at.add(cube.mul(0.044715)).mul(-1.5957691216)).add(1))
    .toVar();
  const slope = h.mul(h.oneMinus()).mul(1.5957691216).mul(at.mul(at).mul(0.134145).add(1));
  return vec2(h, slope);
}

/**
 * Counterpart of shaders/chunks/lineCoverage.glsl.
 *
 * The share of a pixel that a line covers; lengths in pixels.
 *
 * @param away distance from its centre
 * @param fringe how far its edge fades beyond its width
 */
export const lineCoverage = (away: Value, halfWidth: Value, fringe: Input): Value =>
  // A line thinner than a pixel is drawn one pixel wide and paler, so that it does not break up.
  clamp(max(halfWidth, 0.5).add(fringe).sub(away), 0, 1).mul(min(halfWidth.mul(2), 1));

/** Counterpart of shaders/chunks/lightLuminance.glsl: luminance by the weights of Rec. 709. */
export const lightLuminance = (rgb: Value): Value => dot(rgb, vec3(0.2126, 0.7152, 0.0722));
