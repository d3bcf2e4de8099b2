import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { medianInterval } from '../statistics.mjs';
import { figure, table } from '../table.mjs';
import { servePlayground } from './servePlayground.mjs';
import { timeDrop, untilIdle } from './timeDrop.mjs';
import { writeModelFile } from './writeModelFile.mjs';

const FILES = { 'torus12k.ply': [60, 100], 'torus200k.ply': [250, 400], 'torus200k.stl': [250, 400] };
const PLAN = { files: Object.keys(FILES), pages: 6, drops: 3 };
const QUICK = { files: ['torus12k.ply'], pages: 1, drops: 2 };

/** The time from handing a file to the playground to the first frame that shows it. */
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
        writeModelFile(path, ...FILES[file]);
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
          triangles: 2 * FILES[file][0] * FILES[file][1],
          cold: medianInterval(cold),
          warm: medianInterval(warm),
        };
      }
    } finally {
      await playground.close();
      rmSync(folder, { recursive: true });
    }
    return { pages, drops, rows };
  },

  describe({ pages, drops, rows }) {
    const time = ([median, low, high]) => `${figure(median)} [${figure(low)}, ${figure(high)}]`;
    return `ms; ${pages} pages, ${drops} files each.

${table([
  ['', 'triangles', 'cold', 'warm'],
  ...Object.entries(rows).map(([file, { triangles, cold, warm }]) => [
    file,
    triangles.toLocaleString('en'),
    time(cold),
    time(warm),
  ]),
])}`;
  },
};
