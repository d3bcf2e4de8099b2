import { median } from '../statistics.mjs';
import { figure, table } from '../table.mjs';

const PLAN = { model: 'dragon202k', parts: 4, repeats: 5 };
const QUICK = { model: 'torus20k', parts: 4, repeats: 2 };
const ARRANGEMENTS = ['inTurn', 'together'];

/** How long it takes from a loaded model to its first hatched picture. */
export const firstPicture = {
  name: 'firstPicture',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { model, parts, repeats } = isQuick ? QUICK : PLAN;
    const times = { inTurn: [], together: [] };
    for (let i = 0; i < repeats; i++) {
      const turn = i % 2 === 0 ? ARRANGEMENTS : [...ARRANGEMENTS].reverse();
      for (const arrangement of turn) {
        times[arrangement].push(await measure('firstPicture', model, parts, arrangement));
      }
    }
    const medians = Object.fromEntries(ARRANGEMENTS.map((name) => [name, mediansOf(times[name])]));
    const ratio = median(times.together.map(({ whole }, i) => whole / times.inTurn[i].whole));
    return { model, parts, repeats, medians, ratio };
  },

  describe({ model, parts, repeats, medians, ratio }) {
    const phases = [...new Set(ARRANGEMENTS.flatMap((name) => Object.keys(medians[name])))].filter(
      (p) => p !== 'whole',
    );
    return `${model} in ${parts} meshes, ms, medians of ${repeats}; together takes ${figure(ratio)} of the time in turn.

${table([
  ['', 'in turn', 'together'],
  ...[...phases, 'whole'].map((phase) => [phase, ...ARRANGEMENTS.map((name) => cell(medians[name][phase]))]),
])}`;
  },
};

const cell = (time) => (time === undefined ? '' : figure(time));

function mediansOf(runs) {
  return Object.fromEntries(Object.keys(runs[0]).map((phase) => [phase, median(runs.map((run) => run[phase]))]));
}
