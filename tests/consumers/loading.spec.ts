import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { measureLoading } from '../../tools/browser/measureLoading.mjs';
import { expect, test } from '../browser/test.js';
import { installPackedLibrary, libraryFolder, projectFolder, threeFolder } from './packedLibrary.js';
import { viteBuild } from './viteBuild.js';

/** The most bytes after gzip, without three.js, that the three lines of the README load at once, and from then on until strokes are drawn. */
const MOST_AT_ONCE = 31_000;
const MOST_LATER = 99_000;

/** The worker, what hatches scenes, what all techniques share, lines, and outlines. */
const MOST_REQUESTS = 5;

/** Part of a sentence of the checks of first draws. */
const SENTENCE = 'gets no light';

test.beforeAll(() => {
  installPackedLibrary();
});

test('the three lines of the README draw strokes after one wave of few requests, built by Vite', async ({ page }) => {
  const folder = await viteBuild('threeLines', {
    target: 'es2022',
    rolldownOptions: { external: /^three($|\/)/ },
  });
  const loading = await measureLoading(page, { folder, file: 'threeLines.html', three: threeFolder });
  const { atOnce, later, laterBytes, waves } = loading;
  test.info().annotations.push({ type: 'size', description: JSON.stringify(loading) });
  expect(waves).toBe(1);
  expect(later.length, later.join(', ')).toBeLessThanOrEqual(MOST_REQUESTS);
  expect(atOnce).toBeLessThanOrEqual(MOST_AT_ONCE);
  expect(laterBytes).toBeLessThanOrEqual(MOST_LATER);
  const built = join(folder, 'assets');
  for (const file of readdirSync(built)) expect(readFileSync(join(built, file), 'utf8'), file).not.toContain(SENTENCE);
});

test('first draws are checked where a page is developed, and only there', () => {
  const resolved = (...conditions: readonly string[]) =>
    execFileSync(
      process.execPath,
      [...conditions, '--input-type=module', '--eval', "console.log(import.meta.resolve('three-hatching'))"],
      { cwd: projectFolder, encoding: 'utf8' },
    );
  expect(resolved()).toMatch(/\/dist\/index\.js\s*$/);
  expect(resolved('--conditions=development')).toMatch(/\/dist\/development\.js\s*$/);
  const [checked, unchecked] = ['development.js', 'index.js'].map((file) =>
    readFileSync(join(libraryFolder, 'dist', file), 'utf8').includes('checkDraws.js'),
  );
  expect([checked, unchecked]).toEqual([true, false]);
  expect(readFileSync(join(libraryFolder, 'dist/checkDraws.js'), 'utf8')).toContain(SENTENCE);
});
