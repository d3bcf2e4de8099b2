/**
 * `npm run bench:guard`: compares three figures of the working tree with those of the commit that tools/bench/guardedCommit.txt names, as
 * `bench:compare` does. Says what has become slower, and ends with 1 only for what is far slower in two runs. Where the history does not
 * have that commit, nothing is compared.
 */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { buildLibrary } from './compare/buildLibrary.mjs';
import { guardFigure } from './compare/guardFigure.mjs';
import { hasCommit } from './compare/hasCommit.mjs';
import { openBrowser } from './openBrowser.mjs';
import { medianInterval, ratios } from './statistics.mjs';
import { table, withInterval } from './table.mjs';

const EFFORT = { turns: 9, milliseconds: 0 };

/** The measurements, each in its own page. */
const FIGURES = {
  'a frame of dragon48k, no preset': (measure) => measure('comparedSurfaces', 'dragon48k', 'default', EFFORT, 512),
  'a frame of dragon48k, pen': (measure) => measure('comparedSurfaces', 'dragon48k', 'pen', EFFORT, 512),
  'the bake of dragon202k, indexed': (measure) => measure('comparedBakes', 'dragon202k', 'indexed', EFFORT),
};

const commit = readFileSync(new URL('guardedCommit.txt', import.meta.url), 'utf8').trim();
if (hasCommit(commit)) await compareWith(commit);
else console.log(`The history here does not have commit ${commit}, so no speed is compared with it.`);

async function compareWith(commit) {
  const output = fileURLToPath(new URL('../../tests/output/bench/compare/', import.meta.url));
  buildLibrary(commit, `${output}old`);
  buildLibrary(undefined, `${output}new`);
  const browser = await openBrowser('swiftshader');
  const rows = [];
  try {
    for (const [name, measureFigure] of Object.entries(FIGURES)) {
      const { intervals, verdict } = await guardFigure(async () => {
        const times = await measureFigure(browser.measure);
        return medianInterval(ratios(times.new, times.old));
      });
      rows.push([name, intervals.map((interval) => withInterval(interval)).join(', then '), verdict]);
      if (verdict === 'far slower') process.exitCode = 1;
    }
  } finally {
    await browser.close();
  }
  console.log(table([['', `to ${commit.slice(0, 7)}`, ''], ...rows]));
}
