import { servePlayground } from '../drop/servePlayground.mjs';
import { median, medianInterval } from '../statistics.mjs';
import { figure, table } from '../table.mjs';
import { serveCompressed } from './serveCompressed.mjs';
import { NETWORKS, timeColdPage } from './timeColdPage.mjs';

const PLAN = { model: 'dragon202k', parts: 4, repeats: 5, pages: 6 };
const QUICK = { model: 'torus20k', parts: 4, repeats: 1, pages: 1 };
const ARRANGEMENTS = ['inTurn', 'together'];
/** The phases of a page that is opened, in their order, and the longest task. */
const COLD = ['context', 'read', 'sketch', 'whole', 'complete', 'longestTask'];

/** The time from a loaded model to its first hatched picture, and from an address to that of the playground. */
export const firstPicture = {
  name: 'firstPicture',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { model, parts, repeats, pages } = isQuick ? QUICK : PLAN;
    const times = { inTurn: [], together: [] };
    for (let i = 0; i < repeats; i++) {
      const turn = i % 2 === 0 ? ARRANGEMENTS : [...ARRANGEMENTS].reverse();
      for (const arrangement of turn) {
        times[arrangement].push(await measure('firstPicture', model, parts, arrangement));
      }
    }
    const medians = Object.fromEntries(ARRANGEMENTS.map((name) => [name, mediansOf(times[name])]));
    const ratio = median(times.together.map(({ whole }, i) => whole / times.inTurn[i].whole));
    return { model, parts, repeats, medians, ratio, pages, cold: await coldPages(pages) };
  },

  describe({ model, parts, repeats, medians, ratio, pages, cold }) {
    const phases = [...new Set(ARRANGEMENTS.flatMap((name) => Object.keys(medians[name])))].filter(
      (p) => p !== 'whole',
    );
    return `${model} in ${parts} meshes, ms, medians of ${repeats}; together takes ${figure(ratio)} of the time in turn.

${table([
  ['', 'in turn', 'together'],
  ...[...phases, 'whole'].map((phase) => [phase, ...ARRANGEMENTS.map((name) => cell(medians[name][phase]))]),
])}${cold ? describeCold(pages, cold) : ''}`;
  },
};

/** Opens the built playground over each network, in turn. */
async function coldPages(pages) {
  const playground = await servePlayground();
  const host = await serveCompressed(playground.folder);
  const times = Object.fromEntries(Object.keys(NETWORKS).map((network) => [network, []]));
  try {
    for (let i = 0; i < pages; i++) {
      for (const network in NETWORKS) times[network].push(await timeColdPage(host.address, network));
    }
  } finally {
    host.close();
    await playground.close();
  }
  const summary = (runs) =>
    Object.fromEntries(COLD.map((phase) => [phase, medianInterval(runs.map((run) => run[phase]))]));
  return Object.fromEntries(Object.entries(times).map(([network, runs]) => [network, summary(runs)]));
}

function describeCold(pages, cold) {
  const time = ([middle, low, high]) => `${figure(middle)} [${figure(low)}, ${figure(high)}]`;
  return `

The playground, opened in ${pages} new browsers, ms from its address.

${table([
  ['', ...Object.keys(cold)],
  ...COLD.map((phase) => [phase, ...Object.values(cold).map((phases) => time(phases[phase]))]),
])}`;
}

const cell = (time) => (time === undefined ? '' : figure(time));

function mediansOf(runs) {
  return Object.fromEntries(Object.keys(runs[0]).map((phase) => [phase, median(runs.map((run) => run[phase]))]));
}
