import { readFileSync, writeFileSync } from 'node:fs';
import { expect, testOnOnePage } from '../browser/test.js';
import { cases } from '../selection.mjs';
import type { Comparison } from './besideLambert.js';
import { techniques } from './techniques.js';

/** Every feature with every technique beside three's Lambert. `npm run support` writes what is measured into the docs. */

const test = testOnOnePage('tests/gpu/besideLambert.html');
const DOCS = new URL('../../docs/support.md', import.meta.url);
const BEGIN = '<!-- Measured: written by npm run support -->\n';
const END = '<!-- End of what is measured -->';

/** Largest difference that counts as the same, in 1/255; and mean difference. Rounding, and the blur of an environment. */
const MOST = 6;
const MOST_MEAN = 1.5;

const heading = () =>
  `| | | ${techniques.map((one) => `\`${one}\``).join(' | ')} |\n| --- | --- |${techniques.map(() => ' --- |').join('')}\n`;

/** The techniques that a feature is drawn with. They take turns in `npm test`, which draws half of the features, and with other versions of three.js. */
const techniquesOf = (feature: number, three: string | undefined): readonly (typeof techniques)[number][] => {
  const turn = [techniques[feature % techniques.length]];
  const isLeftOut = Math.floor(feature / techniques.length) % 2 > 0;
  return three === undefined ? cases(isLeftOut ? [] : turn, techniques) : turn;
};

test('every feature with every technique is as light as Lambert, and the table in the docs has them all', {
  tag: '@more',
}, async ({ page, three }) => {
  test.slow();
  await page.waitForFunction(() => window.besideLambert !== undefined);
  const features = await page.evaluate(() => window.besideLambert.features);
  const rows: string[] = [];
  let group = '';
  for (const [number, feature] of features.entries()) {
    // Lambert materials of older versions of three.js are not lit by an environment. `npm test` tries a third of the others with the oldest.
    if (three !== undefined && (feature.name === '`scene.environment`' || cases(number % 3 > 0, false))) continue;
    const drawn = techniquesOf(number, three);
    const measured =
      drawn.length === 0
        ? []
        : await page.evaluate(([name, all]) => window.besideLambert.measure(name, all), [feature.name, drawn] as const);
    for (const [i, one] of measured.entries()) expectAlike(one, `${feature.name}, ${drawn[i]}`);
    const cells = measured.map(({ difference }) => String(Math.round(difference)));
    rows.push(
      `| ${feature.group === group ? '' : `**${feature.group}**`} | ${feature.name} | ${cells.join(' | ')} |\n`,
    );
    ({ group } = feature);
  }
  if (three !== undefined) return;
  const text = readFileSync(DOCS, 'utf8');
  const [before, rest] = text.split(BEGIN);
  const [table, after] = rest.split(END);
  if (process.env.UPDATE_SUPPORT) {
    const count = `${features.length} features with ${techniques.length} techniques: ${features.length * techniques.length} set-ups.`;
    writeFileSync(DOCS, `${before}${BEGIN}\n${count}\n\n${heading()}${rows.join('')}\n${END}${after}`);
  } else {
    expect(namesIn(table)).toEqual(namesIn(`\n\n\n\n${heading()}${rows.join('')}`));
  }
});

function expectAlike({ difference, mean, compared, spread }: Comparison, name: string): void {
  expect.soft(compared, `${name}: pixels compared`).toBeGreaterThan(200);
  expect.soft(difference, `${name}: largest difference`).toBeLessThanOrEqual(MOST);
  expect.soft(mean, `${name}: mean difference`).toBeLessThanOrEqual(MOST_MEAN);
  if (!/opacity|`color`|clipping/.test(name)) expect.soft(spread, `${name}: darkest to lightest`).toBeGreaterThan(20);
}

/** The first two columns of a table, and its heading: what was measured, and not how it came out. */
const namesIn = (table: string): string[] =>
  table
    .split('\n')
    .filter((line) => line.startsWith('|'))
    .map((line, i) => (i === 0 ? line : line.split('|').slice(1, 3).join('|').trim()));
