export type Vector = readonly [number, number, number];

export const subtract = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
/** NaN for a vector without length. */
export function unit(a: Vector): Vector {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
}

/** The xyz at an index of an array of them. */
export const vectorAt = (array: ArrayLike<number>, index: number): Vector => [
  array[3 * index],
  array[3 * index + 1],
  array[3 * index + 2],
];

/** Unit normal of the triangle that a corner of a triangle soup belongs to; NaN for one without area. */
export function faceNormal(positions: ArrayLike<number>, corner: number): Vector {
  const first = 3 * Math.floor(corner / 3);
  const [a, b, c] = [0, 1, 2].map((k) => vectorAt(positions, first + k)) as [Vector, Vector, Vector];
  return unit(cross(subtract(b, a), subtract(c, a)));
}
