export type Vector = readonly [x: number, y: number, z: number];

/** A vector of unit length, or zero for zero. */
export function normalized([x, y, z]: Vector): Vector {
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}

export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The front of an object without one of its own: z, or −y where up is z, as is usual in files and programs. */
export const viewedFrom = (up: Vector, front?: Vector): Vector =>
  front ?? (Math.abs(up[2]) < 0.9 ? [0, 0, 1] : [0, -1, 0]);
