import { mix } from '../look/vectors.js';
import type { Chain } from './Chain.js';
import type { Projection } from './Projection.js';
import { type LinePath, PATH_STRIDE } from './paths/LinePath.js';
import { placeOn, type Run } from './visibleRuns.js';

/** Points nearer to each other than this are merged. Pixels. */
const SAME = 1e-4;

/** A run as a path, with the depth of each of its points. */
export interface CutRun {
  path: LinePath;
  depths: number[];
}

/**
 * Cuts a run out of a chain. A run of a closed chain may continue beyond its last point.
 *
 * @param isMoved whether a line with offsets becomes a path at the offset place; otherwise the path stays, and one of its sides is wider
 */
export function cutRun(chain: Chain, [from, to]: Run, projection: Projection, isMoved: boolean): CutRun {
  const { halves, count, isClosed, shifts } = chain;
  const points: number[] = [];
  const beside: number[] = [];
  const depths: number[] = [];
  const add = (place: number) => {
    // The last point of a closed chain is its first.
    const within = place > count - 1 ? place - (count - 1) : place;
    const piece = Math.min(Math.floor(within), count - 2);
    const share = within - piece;
    const at = placeOn(chain, piece, share, projection);
    const half = halves[piece] + share * (halves[piece + 1] - halves[piece]);
    const last = points.length - PATH_STRIDE;
    if (last >= 0 && Math.hypot(at.x - points[last], at.y - points[last + 1]) < SAME) {
      // At a step of the width the greater one counts.
      points[last + 2] = points[last + 3] = Math.max(points[last + 2], half);
      return;
    }
    points.push(at.x, at.y, half, half);
    if (shifts) beside.push(...[0, 1].map((k) => mix(shifts[2 * piece + k], shifts[2 * piece + 2 + k], share)));
    depths.push(projection.depthOf(...at.world));
  };
  add(from);
  for (let place = Math.floor(from) + 1; place < to; place++) add(place);
  add(to);
  const isWhole = isClosed && from === 0 && to === count - 1;
  if (isWhole && points.length > 2 * PATH_STRIDE) {
    points.length -= PATH_STRIDE;
    depths.length--;
  }
  if (shifts) shiftPath({ points, isClosed: isWhole }, beside, isMoved);
  return { path: { points, isClosed: isWhole }, depths };
}

/**
 * Offsets a path sideways; or keeps it in place and widens one side as it narrows the other, so that it stays on its surface.
 *
 * @param beside offset of each point, pixels: two numbers each
 */
export function shiftPath({ points, isClosed }: LinePath, beside: readonly number[], isMoved: boolean): void {
  const changed = points as number[];
  const count = points.length / PATH_STRIDE;
  // Normals are those of the path before.
  const normals = Array.from({ length: count }, (_, i) => leftOf(points, i, isClosed));
  for (let i = 0; i < count; i++) {
    const o = PATH_STRIDE * i;
    const [x, y] = [beside[2 * i], beside[2 * i + 1]];
    if (isMoved) {
      changed[o] += x;
      changed[o + 1] += y;
      continue;
    }
    const towardsLeft = x * normals[i][0] + y * normals[i][1];
    changed[o + 2] += towardsLeft;
    changed[o + 3] -= towardsLeft;
  }
}

/** The unit vector to the left of a path at a point, as in `strokeOutline`. */
function leftOf(points: readonly number[], i: number, isClosed: boolean): readonly [number, number] {
  const count = points.length / PATH_STRIDE;
  const before = PATH_STRIDE * (isClosed ? (i + count - 1) % count : Math.max(i - 1, 0));
  const after = PATH_STRIDE * (isClosed ? (i + 1) % count : Math.min(i + 1, count - 1));
  const [dx, dy] = [points[after] - points[before], points[after + 1] - points[before + 1]];
  const length = Math.hypot(dx, dy) || 1;
  return [-dy / length, dx / length];
}
