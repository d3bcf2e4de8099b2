import type { Bvh } from './Bvh.js';
import type { CutRun } from './cutRun.js';
import type { Projection } from './Projection.js';
import { PATH_STRIDE } from './paths/LinePath.js';
import { leftSide } from './paths/strokeOutline.js';

/** Lines thinner than this do not visibly reach beyond their surface. Pixels. */
const THIN = 0.25;
/** A sample beside a line lies on the same surface if its depth differs by no more than this many half widths. */
const GENTLE = 3;
/** Otherwise the surface is followed in steps of so many pixels, and ends where the depth changes by more than so many pixels at once. */
const STEP = 0.75;
const CLIFF = 10;
const HALVINGS = 3;

/**
 * Limits both sides of a line to where its own surface is visible, so that no ink reaches beyond an outline. Changes the widths of the
 * path. Yields its progress.
 *
 * @param isSheer whether the surface hides nothing, so that rays do not hit it
 */
export function* holdBack(
  { path, depths }: CutRun,
  bvh: Bvh,
  projection: Projection,
  isSheer: boolean,
): Generator<number, void, void> {
  const points = path.points as number[];
  const count = depths.length;
  for (let i = 0; i < count; i++) {
    if (i % 64 === 63) yield i / count;
    const [left, up] = leftSide(path, i);
    const o = PATH_STRIDE * i;
    const pixel = projection.unitsPerPixel(depths[i]);
    for (const side of [0, 1]) {
      const half = points[o + 2 + side];
      if (half < THIN) continue;
      const sign = side === 0 ? 1 : -1;
      const depthAt = (reach: number): number => {
        const x = points[o] + sign * reach * left;
        const y = points[o + 1] + sign * reach * up;
        const { origin, direction } = projection.rayThrough(x, y);
        const met = bvh.firstMet(origin, direction, projection.camera.near);
        return isSheer && met > depths[i] - GENTLE * half * pixel ? depths[i] : met;
      };
      if (Math.abs(depthAt(half) - depths[i]) < GENTLE * half * pixel) continue;
      points[o + 2 + side] = reachOnSurface(depthAt, depths[i], half, CLIFF * pixel);
    }
  }
}

/** How far the surface extends from a place with a depth, up to the distance asked for. */
function reachOnSurface(depthAt: (reach: number) => number, start: number, asked: number, cliff: number): number {
  let depth = start;
  let reach = 0;
  while (reach < asked) {
    const next = Math.min(reach + STEP, asked);
    const met = depthAt(next);
    if (!(Math.abs(met - depth) < cliff)) {
      let [low, high] = [reach, next];
      for (let k = 0; k < HALVINGS; k++) {
        const middle = 0.5 * (low + high);
        if (Math.abs(depthAt(middle) - depth) < cliff) low = middle;
        else high = middle;
      }
      return low;
    }
    depth = met;
    reach = next;
  }
  return asked;
}
