import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { expect, test } from 'vitest';
import { table } from '../../mutations/table/index.js';
import { titleParts, titlePattern } from '../../mutations/titleParts.mjs';
import { root } from '../docs/documents.js';

/** What must have breaks. */
const AREAS = (
  'adjacency archives background bake blending command consent detail element fading engraving exports exposure files form frames hand kept ' +
  'keys lights links maps material mistakes nodes normals occlusion outlines page react repair scan scene shadows slices stipple strokes svg tone ' +
  'undo worker'
).split(' ');

const mutations = Object.values(table).flat();

const read = (path: string): string => readFileSync(join(root, path), 'utf8');

/** The text of a file of tests, and of every file of tests that it takes something from. */
function textsOf(path: string, known = new Map<string, string>()): Map<string, string> {
  if (known.has(path)) return known;
  const text = read(path);
  known.set(path, text);
  for (const [, imported] of text.matchAll(/from '(\.[^']+)'/g)) {
    const target = relative(root, join(root, dirname(path), imported)).replace(/\.js$/, '.ts');
    if (target.startsWith('tests') && existsSync(join(root, target))) textsOf(target, known);
  }
  return known;
}

test('there are at least 260 breaks, in every area', () => {
  expect(mutations.length).toBeGreaterThanOrEqual(260);
  expect(Object.keys(table)).toEqual(expect.arrayContaining(AREAS));
});

test('every break has a name of its own', () => {
  expect(new Set(mutations.map(({ name }) => name)).size).toBe(mutations.length);
});

test('what a break replaces occurs once in its file', () => {
  const wrong = mutations.filter(({ file, find, replace }) => read(file).split(find).length !== 2 || find === replace);
  expect(wrong).toEqual([]);
});

test('the test that must catch a break is there', () => {
  const wrong = mutations.filter(({ caughtBy: { file, title } }) => {
    if (!existsSync(join(root, file))) return true;
    const texts = [...textsOf(file).values()];
    return titleParts(title).some((part) => !texts.some((text) => text.includes(part)));
  });
  expect(wrong).toEqual([]);
});

test('its layer is the folder that it lies in', () => {
  const wrong = mutations.filter(({ caughtBy: { layer, file } }) => !file.startsWith(`tests/${layer}/`));
  expect(wrong).toEqual([]);
});

test('a title becomes a pattern that takes its signs as they are', () => {
  const pattern = new RegExp(titlePattern('what three.js computes … skin (2 bones)'));
  expect(pattern.test('deformed as what three.js computes on the processor: skin (2 bones)')).toBe(true);
  expect(pattern.test('what three-js computes on the processor: skin (2 bones)')).toBe(false);
  expect(pattern.test('what three.js computes on the processor: skin')).toBe(false);
});
