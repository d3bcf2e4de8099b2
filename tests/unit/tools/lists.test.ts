import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { readExamples } from '../../../examples/readExamples.mjs';
import { presets } from '../../../src/scene/presets.js';
import { PRESET_LABELS } from '../../../src/viewer/settings/presetLabels.js';
import { TECHNIQUES } from '../../../tools/properties/techniques.js';

interface Kept {
  names: readonly string[];
  /** The only files that may list all of them: their home, what is written from it, and who says something of each. */
  homes: readonly string[];
}

const LISTS: Record<string, Kept> = {
  presets: {
    names: Object.keys(presets),
    homes: [
      'src/scene/presets.ts',
      // What was measured of each.
      'tools/bench/results/presets.gpu.json',
      'tools/bench/results/presets.llvmpipe.json',
      'tools/bench/results/presets.swiftshader.json',
      'tools/instructions/results.json',
    ],
  },
  techniques: {
    names: Object.keys(TECHNIQUES),
    homes: [
      'tools/properties/techniques.ts',
      // Each property says which of them read it.
      'tools/properties/rows/strokes.ts',
      'src/look/hatchingProperties.ts',
      'src/material/HatchingMaterialProperties.ts',
      // Their labels on the page. The compiler misses one that is left out.
      'src/viewer/settings/table/strokeSettings.ts',
      // What is measured: a technique with a layout or as a look.
      'tools/bench/frame/measureFrames.ts',
      'tools/bench/compare.mjs',
      'tools/metrics/page.ts',
      'tools/metrics/describeMetrics.mjs',
    ],
  },
  examples: { names: readExamples().map(({ folder }) => folder), homes: [] },
};

const sources = ['src', 'tools', 'examples'].flatMap((folder) =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .map((path) => `${folder}/${path}`)
    .filter(
      (path) => /\.(ts|tsx|mjs|js|json|html)$/.test(path) && !/node_modules|\.vitepress\/(cache|dist)/.test(path),
    ),
);

/** Characters that a list takes for a name, at the most. */
const REACH = 90;

/** Of more names than these, a list may lack one and still be a list of all. */
const MANY = 10;

/** Whether strings or keys of a source, close to each other, are all of some names, but for one perhaps if they are many. */
function listsAll(source: string, names: readonly string[]): boolean {
  const code = source.replace(/^\s*(\/\/|\/?\*).*$/gm, '');
  const found = [...code.matchAll(/['"`]([\w-]+)['"`]|\b([\w-]+)(?=:)/g)].flatMap(({ 1: text, 2: key, index }) => {
    const name = text ?? key;
    return names.includes(name) ? [{ name, index }] : [];
  });
  const enough = names.length > MANY ? names.length - 1 : names.length;
  return found.some(({ index: start }) => {
    const near = found.filter(({ index }) => index >= start && index < start + REACH * names.length);
    return new Set(near.map(({ name }) => name)).size >= enough;
  });
}

test.each(Object.entries(LISTS))('no file keeps a list of %s beside their home', (_, { names, homes }) => {
  const keepers = sources.filter((path) => listsAll(readFileSync(path, 'utf8'), names));
  expect(keepers.filter((path) => !homes.includes(path))).toEqual([]);
});

test('a list is noticed: of strings, of keys, and of many names also one that lacks a name', () => {
  const names = ['pen', 'pencil', 'own-map'];
  expect(listsAll(`const ALL = ['pen', "pencil", 'own-map'];`, names)).toBe(true);
  expect(listsAll(`const LABELS = { pen: 'Pen', pencil: 'Pencil', 'own-map': '' };`, names)).toBe(true);
  expect(listsAll(`const SOME = ['pen', 'pencil'];`, names)).toBe(false);
  expect(listsAll(`// 'pen', 'pencil', 'own-map'`, names)).toBe(false);
  const many = Array.from({ length: MANY + 1 }, (_, i) => `name${i}`);
  expect(listsAll(JSON.stringify(many.slice(1)), many)).toBe(true);
  expect(listsAll(JSON.stringify(many.slice(2)), many)).toBe(false);
});

describe('the documentation', () => {
  test('has a row for each preset, in their order', () => {
    const rows = [...readFileSync('docs/presets.md', 'utf8').matchAll(/^\| `(\w+)` \| ([^|]+) \|/gm)];
    expect(rows.map(([, name, label]) => [name, label])).toEqual(Object.entries(PRESET_LABELS));
  });

  test('names each preset in the README, in their order', () => {
    const list = Object.keys(presets)
      .map((name) => `\`${name}\``)
      .join(', ');
    expect(readFileSync('README.md', 'utf8')).toContain(`${list}: [docs/presets.md]`);
  });
});
