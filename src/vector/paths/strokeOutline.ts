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
