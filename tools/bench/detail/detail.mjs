import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { servePlayground } from '../drop/servePlayground.mjs';
import { untilIdle } from '../drop/timeDrop.mjs';
import { peakOf } from '../peakOf.mjs';
import { medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';
import { timeOpening } from './timeOpening.mjs';
import { writeScan } from './writeScan.mjs';

const PLAN = {
  levels: { triangles: 2e6, reference: 5e5, sizes: [250, 500, 1000], turns: 15, zoom: { size: 500, steps: 60 } },
  opened: 1e7,
};
const QUICK = {
  levels: { triangles: 250_000, reference: 50_000, sizes: [64], turns: 2, zoom: { size: 64, steps: 6 } },
  opened: 210_000,
};

/** Frames of a large model drawn in levels, beside those of a smaller one; and how long a very large file takes to be drawn on the page. */
export const detail = {
  name: 'detail',
  perRasteriser: true,

  async run({ measure, openPage, rendererPids }, isQuick) {
    const { levels, opened } = isQuick ? QUICK : PLAN;
    const { seconds, views, flips } = await measure('detail', levels);
    return {
      ...levels,
      seconds,
      flips,
      views: views.map(({ size, drawn, times }) => ({
        size,
        drawn,
        frames: Object.fromEntries(Object.entries(times).map(([name, all]) => [name, medianInterval(all)[0]])),
        toSmaller: medianInterval(ratios(times.levels, times.smaller)),
        toWhole: medianInterval(ratios(times.levels, times.whole)),
      })),
      opening: await open({ openPage, rendererPids }, opened),
    };
  },

  describe({ triangles, reference, turns, seconds, views, zoom, flips, opening }) {
    const { stages, first, ready, longestTask, tasks, peak } = opening;
    const [large, small] = [triangles, reference].map((count) => count.toLocaleString('en'));
    return `A scan of ${large} triangles in levels, hatched with them in ${figure(seconds)} s, beside the whole of it and beside one of ${small}; ${turns} turns, ms a frame.

${table([
  ['canvas', 'triangles of the level', 'levels', 'whole', 'smaller', 'levels / smaller', 'levels / whole'],
  ...views.map(({ size, drawn, frames, toSmaller, toWhole }) => [
    `${size} × ${size}`,
    drawn.toLocaleString('en'),
    ...[frames.levels, frames.whole, frames.smaller].map(figure),
    withInterval(toSmaller),
    withInterval(toWhole),
  ]),
])}

Pixels that flip, by more than 32 of 255 shades, while the camera moves away by 3 % a step on ${zoom.size} × ${zoom.size} pixels.

${table([
  ['steps', 'number', 'levels', 'whole'],
  ...Object.entries({ all: flips.all, 'to another level': flips.replacing }).map(([name, { steps, levels, whole }]) => [
    name,
    ...[steps, levels, whole].map((count) => count.toLocaleString('en')),
  ]),
])}

A PLY file of ${opening.triangles.toLocaleString('en')} triangles, opened on the page; ms from choosing the file until a stage has begun.

${table([
  [...Object.keys(stages), 'first picture', 'complete', 'longest task', 'tasks over 50 ms', 'peak of the page, MB'],
  [...[...Object.values(stages), first, ready, longestTask].map(figure), String(tasks.length), figure(peak / 2 ** 20)],
])}`;
  },
};

async function open({ openPage, rendererPids }, triangles) {
  const folder = mkdtempSync(join(tmpdir(), 'hatching-detail-'));
  const playground = await servePlayground();
  try {
    const path = join(folder, 'scan.ply');
    const written = writeScan(path, triangles);
    const before = new Set(await rendererPids());
    const page = await openPage(playground.address);
    page.setDefaultTimeout(600_000);
    await untilIdle(page);
    const own = (await rendererPids()).filter((pid) => !before.has(pid));
    const times = await timeOpening(page, path);
    const peak = Math.max(...own.map(peakOf));
    await page.close();
    return { triangles: written, ...times, peak };
  } finally {
    await playground.close();
    rmSync(folder, { recursive: true });
  }
}
