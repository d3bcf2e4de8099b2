/** Vectors as tuples, with functions named as in GLSL. */
export type Vec3 = readonly [x: number, y: number, z: number];

/** The vector at an offset of a list of numbers. */
export const vectorAt = (numbers: ArrayLike<number>, o: number): Vec3 => [numbers[o], numbers[o + 1], numbers[o + 2]];

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** s a + t b. */
export const combined = (s: number, a: Vec3, t: number, b: Vec3): Vec3 => [
  s * a[0] + t * b[0],
  s * a[1] + t * b[1],
  s * a[2] + t * b[2],
];

export const lengthOf = (a: Vec3): number => Math.sqrt(dot(a, a));

/** A matrix, given by its rows, times a vector. */
export const timesVector = ([a, b, c]: readonly [Vec3, Vec3, Vec3], v: Vec3): Vec3 => [dot(a, v), dot(b, v), dot(c, v)];

/** The unit vector in the direction of a vector; a zero vector stays zero. */
export function normalize(a: Vec3): Vec3 {
  const length = lengthOf(a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
}

export const clamp01 = (x: number): number => Math.min(1, Math.max(0, x));

export const mix = (a: number, b: number, t: number): number => a + t * (b - a);

export function smoothstep(from: number, to: number, x: number): number {
  const t = clamp01((x - from) / (to - from));
  return t * t * (3 - 2 * t);
}

/** The luminance of a colour in linear light (Rec. 709), as in three's shader chunks. */
export const luminanceOf = ({ r, g, b }: { readonly r: number; readonly g: number; readonly b: number }): number =>
  0.2126 * r + 0.7152 * g + 0.0722 * b;

/** The CIE 1976 lightness of a luminance, both in [0, 1], as in `lightness.glsl`. */
export const lightness = (y: number): number => (y < 216 / 24389 ? y * 9.032963 : 1.16 * Math.cbrt(y) - 0.16);

/** An angle of strokes or lines, in [−π/2, π/2): they have no head, so that half a turn more is the same direction. */
export const axisAngle = (angle: number): number => angle - Math.PI * Math.floor(angle / Math.PI + 0.5);
