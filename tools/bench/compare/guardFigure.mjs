import { verdict } from '../statistics.mjs';

/** A figure fails if its whole interval of new to old lies above this, twice. A busy machine does that by chance once, but hardly twice. */
export const FAR_SLOWER = 1.3;

/**
 * Compares a figure, and once more if it has become far slower.
 *
 * @param {() => Promise<[median: number, low: number, high: number]>} compare - the ratio new to old with its 95 % interval
 * @returns the intervals of both runs, or of one, and `far slower` if both lie above FAR_SLOWER; else what the last run says
 */
export async function guardFigure(compare) {
  const intervals = [await compare()];
  if (isFarSlower(intervals[0])) intervals.push(await compare());
  const fails = intervals.length > 1 && intervals.every(isFarSlower);
  return { intervals, verdict: fails ? 'far slower' : verdict(intervals.at(-1)) };
}

const isFarSlower = ([, low]) => low > FAR_SLOWER;
