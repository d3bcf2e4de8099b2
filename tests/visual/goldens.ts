import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';
import { compareWithGolden, isSingleColour, type Picture, type Verdict } from './gate.js';

const goldenPath = (name: string) => fileURLToPath(new URL(`./goldens/${name}.png`, import.meta.url));
const outputPath = (file: string) => fileURLToPath(new URL(`../output/visual/${file}`, import.meta.url));

/** `UPDATE_GOLDENS=1` writes goldens instead of comparing with them. */
export const updating = process.env.UPDATE_GOLDENS === '1';

/**
 * Holds a picture against its golden, or makes it the golden when updating. Writes `<name>.actual.png`, and where they
 * are not identical `.expected.png` and `.diff.png`, into tests/output/visual.
 *
 * @throws Error for a picture of a single colour, also when updating, and for a golden that is missing
 */
export function judgePicture(name: string, actual: Picture): Verdict {
  if (isSingleColour(actual)) {
    throw new Error(`judgePicture: ${name} has a single colour; nothing was drawn, or the camera sees nothing of it.`);
  }
  for (const kind of ['expected', 'diff']) rmSync(outputPath(`${name}.${kind}.png`), { force: true });
  writePng(outputPath(`${name}.actual.png`), actual);
  if (updating) {
    writePng(goldenPath(name), actual);
    return { verdict: 'identical', text: 'golden written' };
  }
  if (!existsSync(goldenPath(name))) {
    throw new Error(
      `judgePicture: ${name} has no golden; look at tests/output/visual/${name}.actual.png and, if it is right, run UPDATE_GOLDENS=1 npx playwright test --project=visual -g ${name}`,
    );
  }
  const golden = PNG.sync.read(readFileSync(goldenPath(name)));
  const verdict = compareWithGolden(actual, golden);
  if (verdict.verdict !== 'identical') writePng(outputPath(`${name}.expected.png`), golden);
  if (verdict.diff) writePng(outputPath(`${name}.diff.png`), verdict.diff);
  return verdict;
}

function writePng(path: string, { width, height, data }: Picture): void {
  mkdirSync(new URL('.', `file://${path}`), { recursive: true });
  const png = new PNG({ width, height });
  png.data = Buffer.from(data);
  writeFileSync(path, PNG.sync.write(png));
}
