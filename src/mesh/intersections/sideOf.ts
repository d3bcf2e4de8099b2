/** Relative rounding error of a triple product of exact differences, as a share of the sum of its terms' magnitudes (Shewchuk, 1997). */
export const TRIPLE_ERROR = 8e-16;
/** The same for a product of two differences. */
const PAIR_ERROR = 4e-16;

/** The sign of w·(u×v) for vectors of whole numbers below 2^53, exact. */
export function tripleSign(
  wx: number,
  wy: number,
  wz: number,
  ux: number,
  uy: number,
  uz: number,
  vx: number,
  vy: number,
  vz: number,
): number {
  const ax = uy * vz;
  const bx = uz * vy;
  const ay = uz * vx;
  const by = ux * vz;
  const az = ux * vy;
  const bz = uy * vx;
  const product = wx * (ax - bx) + wy * (ay - by) + wz * (az - bz);
  const terms =
    (Math.abs(ax) + Math.abs(bx)) * Math.abs(wx) +
    (Math.abs(ay) + Math.abs(by)) * Math.abs(wy) +
    (Math.abs(az) + Math.abs(bz)) * Math.abs(wz);
  if (product > TRIPLE_ERROR * terms) return 1;
  if (-product > TRIPLE_ERROR * terms) return -1;
  return exactTriple(wx, wy, wz, ux, uy, uz, vx, vy, vz);
}

/**
 * `tripleSign`, but a product of 0 has the sign that it gets once the second of two surfaces is moved by a vector (1, ε, ε²) with an
 * infinitely small ε, so that surfaces are never just in contact. 0 only if u and v are parallel.
 *
 * @param shift 1 where w grows with that movement, −1 where it shrinks
 */
export function sideOf(
  wx: number,
  wy: number,
  wz: number,
  ux: number,
  uy: number,
  uz: number,
  vx: number,
  vy: number,
  vz: number,
  shift: 1 | -1,
): number {
  const exact = tripleSign(wx, wy, wz, ux, uy, uz, vx, vy, vz);
  if (exact !== 0) return exact;
  return shift * (pairSign(uy, vz, uz, vy) || pairSign(uz, vx, ux, vz) || pairSign(ux, vy, uy, vx));
}

function exactTriple(
  wx: number,
  wy: number,
  wz: number,
  ux: number,
  uy: number,
  uz: number,
  vx: number,
  vy: number,
  vz: number,
): number {
  const [x, y, z] = [BigInt(ux), BigInt(uy), BigInt(uz)];
  const [a, b, c] = [BigInt(vx), BigInt(vy), BigInt(vz)];
  return signOf(BigInt(wx) * (y * c - z * b) + BigInt(wy) * (z * a - x * c) + BigInt(wz) * (x * b - y * a));
}

/** The sign of ab − cd, exact. */
function pairSign(a: number, b: number, c: number, d: number): number {
  const [ab, cd] = [a * b, c * d];
  const difference = ab - cd;
  if (Math.abs(difference) > PAIR_ERROR * (Math.abs(ab) + Math.abs(cd))) return Math.sign(difference);
  return signOf(BigInt(a) * BigInt(b) - BigInt(c) * BigInt(d));
}

const signOf = (value: bigint): number => (value > 0n ? 1 : value < 0n ? -1 : 0);
