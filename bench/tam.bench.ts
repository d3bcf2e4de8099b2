import { generateHatchImages } from '../src/hatchImages/generateHatchImages.js';
import type { HatchImageOptions } from '../src/hatchImages/hatchImageOptions.js';

/** Time to draw tonal art maps on one thread; no worker, no transfer, no upload. */
export const name = 'tam';

const REPEATS = 3;

interface Measurement {
  /** Of the first drawing, which pays for compiling, and the median of the following ones; milliseconds. */
  firstMs: number;
  medianMs: number;
  /** Longest time between two yields in the repeats: what a slice on the main thread may overrun by. */
  longestStepMs: number;
}

export async function run(): Promise<Record<string, Measurement>> {
  const maps: Record<string, HatchImageOptions> = {
    default: {},
    crossHatching256: { style: 'crossHatching' },
    stippling256: { style: 'stippling' },
    hatching1024: { size: 1024 },
    stippling1024: { style: 'stippling', size: 1024 },
  };
  const results: Record<string, Measurement> = {};
  for (const [key, options] of Object.entries(maps)) results[key] = measure(options);
  return results;
}

function measure(options: HatchImageOptions): Measurement {
  const first = timed(options);
  const repeats = Array.from({ length: REPEATS }, () => timed(options));
  return {
    firstMs: round(first.totalMs),
    medianMs: round(repeats.map(({ totalMs }) => totalMs).toSorted((a, b) => a - b)[REPEATS >> 1]),
    longestStepMs: round(Math.max(...repeats.map(({ longestStepMs }) => longestStepMs))),
  };
}

function timed(options: HatchImageOptions): { totalMs: number; longestStepMs: number } {
  const begin = performance.now();
  const task = generateHatchImages(options);
  let longestStepMs = 0;
  for (let last = begin; ; ) {
    const { done } = task.next();
    const now = performance.now();
    longestStepMs = Math.max(longestStepMs, now - last);
    last = now;
    if (done) return { totalMs: now - begin, longestStepMs };
  }
}

const round = (value: number): number => Number(value.toPrecision(3));
