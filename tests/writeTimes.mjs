/**
 * `npm run test:times`: writes what the layers took into the table of CONTRIBUTING.md, from the last whole runs of `npm test` and `npm run test:rest`.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const document = fileURLToPath(new URL('../CONTRIBUTING.md', import.meta.url));
/** @returns {{ seconds: number, layers: import('./layerTimes.mjs').LayerTime[] }} */
const read = (selection) =>
  JSON.parse(readFileSync(new URL(`output/times/${selection}.json`, import.meta.url), 'utf8'));

const quick = read('quick');
const rest = read('rest');
const cell = (times, name) => {
  const found = times.layers.find(({ layer }) => layer === name);
  return found ? `${Math.round(found.seconds)} (${found.tests.toLocaleString('en')})` : '–';
};
const clock = ({ seconds }) => `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
const table = [
  '| layer | `npm test`: seconds (tests) | `npm run test:rest` |',
  '| --- | ---: | ---: |',
  ...quick.layers.map(({ layer }) => `| ${layer} | ${cell(quick, layer)} | ${cell(rest, layer)} |`),
  `| on the clock | ${clock(quick)} | ${clock(rest)} |`,
];

const text = readFileSync(document, 'utf8');
const [begin, end] = ['<!-- times: npm run test:times -->\n', '<!-- times end -->'];
if (!text.includes(begin) || !text.includes(end))
  throw new Error('CONTRIBUTING.md has no place for the table of times.');
const before = text.slice(0, text.indexOf(begin) + begin.length);
writeFileSync(document, `${before}\n${table.join('\n')}\n\n${text.slice(text.indexOf(end))}`);
