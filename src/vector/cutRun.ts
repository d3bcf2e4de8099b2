import { mix } from '../look/vectors.js';
import type { Bvh } from './Bvh.js';
import type { Chain } from './Chain.js';
import type { Projection } from './Projection.js';
import { type LinePath, PATH_STRIDE, reversedPoints } from './paths/LinePath.js';
import { leftSide } from './paths/strokeOutline.js';
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
function shiftPath({ points, isClosed }: LinePath, beside: readonly number[], isMoved: boolean): void {
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

/** Distance between points near the ends of a line, pixels, and the length of these parts in half widths. */
const END_STEP = 0.6;
const REACH = 2;
/** Thinner lines end as they are, pixels. */
const THIN_END = 0.4;

/**
 * Adds points near the ends of an open run, so that each can be limited on its own: occluders rarely run straight across a line, and cut
 * the end of a broad one at a slant.
 */
export function refineEnds(cut: CutRun): CutRun {
  if (cut.path.isClosed || cut.depths.length < 2) return cut;
  return reversed(refinedStart(reversed(refinedStart(cut))));
}

function refinedStart({ path, depths }: CutRun): CutRun {
  const { points } = path;
  const half = points[2];
  const reach = REACH * half;
  if (half < THIN_END) return { path, depths };
  const finer: number[] = [];
  const finerDepths: number[] = [];
  let walked = 0;
  let i = 0;
  for (; i + 1 < depths.length && walked < reach; i++) {
    const o = PATH_STRIDE * i;
    const length = Math.hypot(points[o + PATH_STRIDE] - points[o], points[o + PATH_STRIDE + 1] - points[o + 1]);
    const count = Math.max(1, Math.ceil(Math.min(length, reach - walked) / END_STEP));
    for (let k = 0; k < count; k++) {
      const share = length > 0 ? Math.min((k * END_STEP) / length, 1) : 0;
      for (let n = 0; n < PATH_STRIDE; n++)
        finer.push(points[o + n] + share * (points[o + PATH_STRIDE + n] - points[o + n]));
      finerDepths.push(depths[i] + share * (depths[i + 1] - depths[i]));
    }
    walked += length;
  }
  return {
    path: { points: [...finer, ...points.slice(PATH_STRIDE * i)], isClosed: false },
    depths: [...finerDepths, ...depths.slice(i)],
  };
}

const reversed = ({ path, depths }: CutRun): CutRun => ({
  path: { points: reversedPoints(path.points), isClosed: path.isClosed },
  depths: depths.toReversed(),
});

/** Lines thinner than this do not visibly reach beyond their surface. Pixels. */
const THIN_SIDE = 0.25;
/** A sample beside a line lies on the same surface if its depth differs by no more than this many half widths. */
const GENTLE = 3;
/** Otherwise the surface is followed in steps of so many pixels, and ends where the depth changes by more than so many pixels at once. */
const SIDE_STEP = 0.75;
const CLIFF = 10;
const HALVINGS = 3;

/**
 * Limits both sides of a line to where its own surface is visible, so that no ink reaches beyond an outline. Changes the widths of the
 * path. Yields its progress.
 *
 * @param isSheer whether the surface hides nothing, so that rays do not hit it
 */
export function* limitToSurface(
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
      if (half < THIN_SIDE) continue;
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
    // A stroke beside its path has no width where the surface ends before it.
    if (points[o + 2] + points[o + 3] < 0) points[o + 3] = -points[o + 2];
  }
}

/** How far the surface extends from a place with a depth, up to the distance asked for. */
function reachOnSurface(depthAt: (reach: number) => number, start: number, asked: number, cliff: number): number {
  let depth = start;
  let reach = 0;
  while (reach < asked) {
    const next = Math.min(reach + SIDE_STEP, asked);
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
