import { type LinePath, PATH_STRIDE } from './LinePath.js';

/** Removes points of a path that change neither place nor width by more than the tolerance, pixels (Douglas and Peucker, 1973). */
export function simplify({ points, isClosed }: LinePath, tolerance: number): LinePath {
  // A closed path ends where it begins.
  const all = isClosed ? [...points, ...points.slice(0, PATH_STRIDE)] : points;
  const count = all.length / PATH_STRIDE;
  if (count <= 2) return { points, isClosed };
  const keeps = new Uint8Array(count);
  keeps[0] = keeps[count - 1] = 1;
  const stack: (readonly [number, number])[] = [[0, count - 1]];
  for (let range = stack.pop(); range; range = stack.pop()) {
    const worst = worstBetween(all, range[0], range[1], tolerance);
    if (worst < 0) continue;
    keeps[worst] = 1;
    stack.push([range[0], worst], [worst, range[1]]);
  }
  const kept: number[] = [];
  for (let i = 0; i < count - Number(isClosed); i++) {
    if (keeps[i] === 1) kept.push(...all.slice(PATH_STRIDE * i, PATH_STRIDE * (i + 1)));
  }
  return { points: kept, isClosed: isClosed && kept.length > 2 * PATH_STRIDE };
}

/** The point farthest from the straight line between two; −1 if all lie within the tolerance. */
function worstBetween(points: readonly number[], first: number, last: number, tolerance: number): number {
  const [a, b] = [PATH_STRIDE * first, PATH_STRIDE * last];
  const [dx, dy] = [points[b] - points[a], points[b + 1] - points[a + 1]];
  const square = dx * dx + dy * dy;
  let [most, worst] = [tolerance, -1];
  for (let i = first + 1; i < last; i++) {
    const o = PATH_STRIDE * i;
    const [x, y] = [points[o] - points[a], points[o + 1] - points[a + 1]];
    const t = square > 0 ? Math.min(1, Math.max(0, (x * dx + y * dy) / square)) : 0;
    let off = Math.hypot(x - t * dx, y - t * dy);
    for (const side of [2, 3]) {
      const width = points[a + side] + t * (points[b + side] - points[a + side]);
      off = Math.max(off, Math.abs(points[o + side] - width));
    }
    if (off > most) [most, worst] = [off, i];
  }
  return worst;
}
