import type { Ring } from './strokeOutline.js';

/** The part of a ring within a rectangle from the origin (Sutherland and Hodgman, 1974); empty if there is none. */
export function clipRing(ring: Ring, width: number, height: number): Ring {
  let clipped = ring;
  for (const [axis, limit, sign] of [
    [0, 0, 1],
    [0, width, -1],
    [1, 0, 1],
    [1, height, -1],
  ]) {
    clipped = clipAt(clipped, axis, limit, sign);
  }
  return clipped;
}

/** The part of a ring on one side of a limit. sign: 1 keeps what is above it, −1 what is below. */
function clipAt(ring: Ring, axis: number, limit: number, sign: number): Ring {
  const kept: number[] = [];
  const count = ring.length / 2;
  for (let i = 0; i < count; i++) {
    const [x, y] = [ring[2 * i], ring[2 * i + 1]];
    const next = 2 * ((i + 1) % count);
    const here = sign * (ring[2 * i + axis] - limit);
    const there = sign * (ring[next + axis] - limit);
    if (here >= 0) kept.push(x, y);
    if (here >= 0 === there >= 0) continue;
    const t = here / (here - there);
    const crossing = [x + t * (ring[next] - x), y + t * (ring[next + 1] - y)];
    crossing[axis] = limit;
    kept.push(...crossing);
  }
  return kept.length < 6 ? [] : kept;
}
