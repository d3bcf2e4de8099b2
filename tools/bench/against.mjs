import { median, medianInterval, ratios } from './statistics.mjs';
import { figure, table, withInterval } from './table.mjs';

/** Measures models on which each drawing is compared with another one. @returns {Promise<object>} for `describeAgainst` */
export async function runAgainst(measure, name, { models, size }) {
  const results = {};
  for (const [model, turns] of Object.entries(models)) {
    const { times, against, triangles } = await measure(name, model, turns, size);
    const drawn = Object.entries(times).map(([drawing, list]) => [
      drawing,
      { ms: median(list), to: against[drawing], ratio: medianInterval(ratios(list, times[against[drawing]])) },
    ]);
    results[model] = { triangles, turns, drawn: Object.fromEntries(drawn) };
  }
  return { size, models: results };
}

/** A table for each model. */
export function describeAgainst({ size, models }) {
  const parts = Object.entries(models).map(
    ([model, { triangles, turns, drawn }]) => `${model}, ${triangles.toLocaleString('en')} triangles, ${turns} turns:

${table([
  ['', 'ms', 'to', 'ratio'],
  ...Object.entries(drawn).map(([name, { ms, to, ratio }]) => [
    name,
    figure(ms),
    to === name ? '' : to,
    to === name ? '1' : withInterval(ratio),
  ]),
])}`,
  );
  return `${size} × ${size} pixels.\n\n${parts.join('\n\n')}`;
}
