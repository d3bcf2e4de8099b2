import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { medianInterval } from '../statistics.mjs';
import { figure, table } from '../table.mjs';
import { servePlayground } from './servePlayground.mjs';
import { timeDrop, untilIdle } from './timeDrop.mjs';
import { dragon, torus, writeModelFile } from './writeModelFile.mjs';

/** The files, with the number of pages on which each is dropped and the number of drops on each page. */
const FILES = {
  'torus12k.ply': { make: torus(60, 100), pages: 3, drops: 3 },
  'torus200k.ply': { make: torus(250, 400), pages: 3, drops: 2 },
  'torus200k.stl': { make: torus(250, 400), pages: 2, drops: 2 },
  'dragon871k.glb': { make: dragon, pages: 2, drops: 2 },
  'torus2m.ply': { make: torus(1000, 1000), pages: 3, drops: 1 },
};
const QUICK = { 'torus12k.ply': { ...FILES['torus12k.ply'], pages: 1, drops: 2 } };

/** A page with a model that is soon drawn whole, in the look of a page that is opened: its programs are built by then. */
const ADDRESS = '#model=cube';

/** The time from dropping a file on the playground to the first frame that shows it. */
export const drop = {
  name: 'drop',
  perRasteriser: true,

  async run({ openPage }, isQuick) {
    const folder = mkdtempSync(join(tmpdir(), 'hatching-drop-'));
    const playground = await servePlayground();
    const rows = {};
    try {
      for (const [file, { make, pages, drops }] of Object.entries(isQuick ? QUICK : FILES)) {
        const path = join(folder, file);
        const geometry = make();
        writeModelFile(path, geometry);
        const [cold, warm] = [[], []];
        for (let i = 0; i < pages; i++) {
          const page = await openPage(`${playground.address}${ADDRESS}`);
          for (let count = 0; count < drops; count++) {
            // Work of a page after a drop must not delay the next drop.
            await untilIdle(page);
            (count === 0 ? cold : warm).push(await timeDrop(page, path));
          }
          await page.close();
        }
        rows[file] = {
          triangles: geometry.index.count / 3,
          drops: pages * drops,
          cold: summarise(cold),
          warm: summarise(warm),
        };
      }
    } finally {
      await playground.close();
      rmSync(folder, { recursive: true });
    }
    return { rows };
  },

  describe({ pages, drops, rows }) {
    const time = (interval) => {
      if (!interval) return '';
      const [median, low, high] = interval.map(figure);
      return `${median} [${low}, ${high}]`;
    };
    return `ms.

${table([
  [
    '',
    'triangles',
    'drops',
    'cold, read',
    'cold, first',
    'cold, baked',
    'warm, read',
    'warm, first',
    'warm, baked',
    'longest task, warm',
  ],
  ...Object.entries(rows).map(([file, { triangles, cold, warm, ...row }]) => [
    file,
    triangles.toLocaleString('en'),
    String(row.drops ?? pages * drops),
    time(cold.read),
    time(cold.first),
    time(cold.ready),
    time(warm.read),
    time(warm.first),
    time(warm.ready),
    time(warm.longestTask),
  ]),
])}`;
  },
};

const summarise = (drops) =>
  Object.fromEntries(Object.keys(drops[0] ?? {}).map((key) => [key, medianInterval(drops.map((times) => times[key]))]));
