import { type LinePath, PATH_STRIDE } from './LinePath.js';

/** Corners of a ring: x and y in turn. */
export type Ring = readonly number[];

/** Mitre limit, in half widths. */
const LONGEST_MITRE = 1.5;

/** The outline of a path with varying width, as rings to be filled by the rule `nonzero`: one, or two for a closed path. */
export function strokeOutline({ points, isClosed }: LinePath): Ring[] {
  const count = points.length / PATH_STRIDE;
  const left: number[] = [];
  const right: number[] = [];
  for (let i = 0; i < count; i++) {
    const o = PATH_STRIDE * i;
    const [x, y] = leftSide({ points, isClosed }, i);
    left.push(points[o] + x * points[o + 2], points[o + 1] + y * points[o + 2]);
    right.push(points[o] - x * points[o + 3], points[o + 1] - y * points[o + 3]);
  }
  const back: number[] = [];
  for (let i = count - 1; i >= 0; i--) back.push(right[2 * i], right[2 * i + 1]);
  // The inner ring of a closed path runs the other way, and leaves a hole.
  return isClosed ? [left, back] : [[...left, ...back]];
}

/** The vector from a point to the left side of a path, in half widths; longer at turns, by the mitre. The right side is opposite. */
export function leftSide({ points, isClosed }: LinePath, i: number): readonly [x: number, y: number] {
  const count = points.length / PATH_STRIDE;
  const before = isClosed ? (i + count - 1) % count : Math.max(i - 1, 0);
  const after = isClosed ? (i + 1) % count : Math.min(i + 1, count - 1);
  // The mean of both unit directions, so that a long piece does not outweigh a short one.
  let [tx, ty] = [0, 0];
  for (const [a, b] of [
    [before, i],
    [i, after],
  ]) {
    const dx = points[PATH_STRIDE * b] - points[PATH_STRIDE * a];
    const dy = points[PATH_STRIDE * b + 1] - points[PATH_STRIDE * a + 1];
    const length = Math.hypot(dx, dy);
    if (length > 0) [tx, ty] = [tx + dx / length, ty + dy / length];
  }
  const length = Math.hypot(tx, ty);
  if (length === 0) return [0, 1];
  const isEnd = before === i || after === i;
  const mitre = isEnd ? 1 : Math.min(2 / Math.max(length, 1), LONGEST_MITRE);
  return [(-ty / length) * mitre, (tx / length) * mitre];
}

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
