import { fileURLToPath } from 'node:url';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { describeRenderer } from '../tests/browser/describeRenderer.mjs';
import { launchOptions } from '../tests/browser/launchOptions.mjs';

/**
 * Time of one frame of the dragon, hatched and with three's Phong material on the same expanded geometry and on the plain
 * indexed one, 1024 × 1024. They are drawn in turn, and ratios are taken within a turn: on a busy machine times drift by a
 * factor of two, ratios hardly.
 */
export const name = 'frame';

const TURNS = { dragon11k: 25, dragon48k: 25, dragon202k: 15, dragon871k: 7 };

export async function run() {
  console.log(`frame: ${(await describeRenderer()).renderer}`);
  const server = await createServer({
    root: fileURLToPath(new URL('..', import.meta.url)),
    mode: 'test',
    logLevel: 'error',
    server: { host: '127.0.0.1', port: 0 },
  });
  await server.listen();
  const browser = await chromium.launch(await launchOptions());
  try {
    const rows = {};
    for (const [model, turns] of Object.entries(TURNS)) {
      const page = await browser.newPage();
      await page.goto(`${server.resolvedUrls.local[0]}bench/frame.html`);
      await page.waitForFunction(() => typeof window.measureFrames === 'function');
      rows[model] = summarise(
        await page.evaluate(([model, turns]) => window.measureFrames(model, turns), [model, turns]),
      );
      await page.close();
    }
    return rows;
  } finally {
    await browser.close();
    await server.close();
  }
}

/** Medians of the times, and of the ratios within a turn. */
function summarise({ triangles, times }) {
  const row = { triangles };
  for (const [drawn, list] of Object.entries(times)) row[`${drawn}Ms`] = round(median(list));
  const ratio = (a, b) => round(median(times[a].map((time, turn) => time / times[b][turn])));
  row['adjacency/phong'] = ratio('adjacency', 'phong');
  row['triangle/phong'] = ratio('triangle', 'phong');
  row['anchored/phong'] = ratio('anchored', 'phong');
  row['anchoredIndexed/phong'] = ratio('anchoredIndexed', 'phong');
  row['anchoredIndexed/adjacency'] = ratio('anchoredIndexed', 'adjacency');
  row['anchoredIndexed/phongIndexed'] = ratio('anchoredIndexed', 'phongIndexed');
  row['adjacency/phongIndexed'] = ratio('adjacency', 'phongIndexed');
  row['phong/phongIndexed'] = ratio('phong', 'phongIndexed');
  return row;
}

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
const round = (value) => Number(value.toPrecision(3));
