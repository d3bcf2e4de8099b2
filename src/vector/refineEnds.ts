import type { CutRun } from './cutRun.js';
import { PATH_STRIDE, reversedPoints } from './paths/LinePath.js';

/** Distance between points near the ends of a line, pixels, and the length of these parts in half widths. */
const STEP = 0.6;
const REACH = 2;
/** Thinner lines end as they are, pixels. */
const THIN = 0.4;

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
  if (half < THIN) return { path, depths };
  const finer: number[] = [];
  const finerDepths: number[] = [];
  let walked = 0;
  let i = 0;
  for (; i + 1 < depths.length && walked < reach; i++) {
    const o = PATH_STRIDE * i;
    const length = Math.hypot(points[o + PATH_STRIDE] - points[o], points[o + PATH_STRIDE + 1] - points[o + 1]);
    const count = Math.max(1, Math.ceil(Math.min(length, reach - walked) / STEP));
    for (let k = 0; k < count; k++) {
      const share = length > 0 ? Math.min((k * STEP) / length, 1) : 0;
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
