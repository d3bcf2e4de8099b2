import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { medianInterval } from '../statistics.mjs';
import { figure, table } from '../table.mjs';
import { servePlayground } from './servePlayground.mjs';
import { timeDrop, untilIdle } from './timeDrop.mjs';
import { dragon, torus, writeModelFile } from './writeModelFile.mjs';

const FILES = {
  'torus12k.ply': torus(60, 100),
  'torus200k.ply': torus(250, 400),
  'torus200k.stl': torus(250, 400),
  'dragon871k.glb': dragon,
  'torus2m.ply': torus(1000, 1000),
};
const PLAN = { files: Object.keys(FILES), pages: 6, drops: 3 };
const QUICK = { files: ['torus12k.ply'], pages: 1, drops: 2 };

/** The time from dropping a file on the playground to the first frame that shows it. */
export const drop = {
  name: 'drop',
  perRasteriser: true,

  async run({ openPage }, isQuick) {
    const { files, pages, drops } = isQuick ? QUICK : PLAN;
    const folder = mkdtempSync(join(tmpdir(), 'hatching-drop-'));
    const playground = await servePlayground();
    const rows = {};
    try {
      for (const file of files) {
        const path = join(folder, file);
        const geometry = FILES[file]();
        writeModelFile(path, geometry);
        const [cold, warm] = [[], []];
        for (let i = 0; i < pages; i++) {
          const page = await openPage(playground.address);
          await untilIdle(page);
          for (let count = 0; count < drops; count++) {
            (count === 0 ? cold : warm).push(await timeDrop(page, path));
            await untilIdle(page);
          }
          await page.close();
        }
        rows[file] = {
          triangles: geometry.index.count / 3,
          cold: summarise(cold),
          warm: summarise(warm),
        };
      }
    } finally {
      await playground.close();
      rmSync(folder, { recursive: true });
    }
    return { pages, drops, rows };
  },

  describe({ pages, drops, rows }) {
    const time = (interval) => {
      if (!interval) return '';
      const [median, low, high] = interval.map(figure);
      return `${median} [${low}, ${high}]`;
    };
    return `ms; ${pages} pages, ${drops} files each.

${table([
  [
    '',
    'triangles',
    'cold, read',
    'cold, first',
    'cold, baked',
    'warm, read',
    'warm, first',
    'warm, baked',
    'longest task, warm',
  ],
  ...Object.entries(rows).map(([file, { triangles, cold, warm }]) => [
    file,
    triangles.toLocaleString('en'),
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
  Object.fromEntries(Object.keys(drops[0]).map((key) => [key, medianInterval(drops.map((times) => times[key]))]));
