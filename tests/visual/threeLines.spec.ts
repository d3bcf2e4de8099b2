import { readFileSync, writeFileSync } from 'node:fs';
import { PNG } from 'pngjs';
import { readmeLines, THREE_LINES_SIZE } from '../../tools/pictures/readmeLines.mjs';
import { expect, test } from '../browser/test.js';
import { compareWithGolden } from './gate.js';

test('the first lines of the README draw the picture beside them, on a page that has nothing else', async ({
  page,
}) => {
  await page.goto('/tools/pictures/threeLines.html');
  await page.waitForFunction(() => window.drawThreeLines !== undefined);
  const address = await page.evaluate(([code, [width, height]]) => window.drawThreeLines!(code, width, height), [
    readmeLines(),
    THREE_LINES_SIZE,
  ] as const);
  const file = Buffer.from(address.slice(address.indexOf(',') + 1), 'base64');
  writeFileSync(test.info().outputPath('three-lines.png'), file);
  const picture = PNG.sync.read(readFileSync('docs/three-lines.png'));
  const { verdict, text } = compareWithGolden(PNG.sync.read(file), picture);
  console.log(`  three lines: ${text}`);
  expect(verdict, text).not.toBe('different');
});
