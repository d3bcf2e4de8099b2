import { readdirSync, readFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { expect, test } from 'vitest';

const MAX_LINES = 420;
const MAX_FILES = 30;

const files = readdirSync('src', { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile() && /\.(tsx?|css)$/.test(entry.name))
  .map((entry) => `${entry.parentPath}/${entry.name}`);

test(`no file of src has more than ${MAX_LINES} lines, unless a script writes it`, () => {
  const long = files
    .map((path) => ({ path, text: readFileSync(path, 'utf8') }))
    .filter(({ text }) => !text.startsWith('// Written by') && text.split('\n').length - 1 > MAX_LINES)
    .map(({ path }) => path);
  expect(files.length).toBeGreaterThan(300);
  expect(long).toEqual([]);
});

test(`no folder of src has more than ${MAX_FILES} files`, () => {
  const counts = new Map<string, number>();
  for (const path of files) counts.set(dirname(path), (counts.get(dirname(path)) ?? 0) + 1);
  expect([...counts].filter(([, count]) => count > MAX_FILES)).toEqual([]);
});
