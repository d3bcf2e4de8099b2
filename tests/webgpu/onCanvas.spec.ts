import { writeFileSync } from 'node:fs';
import { expect } from '../browser/test.js';
import { cases as selected } from '../selection.mjs';
import { test } from './besideGlsl.js';

/** Outlines on canvases: `WebGLRenderer` blends sRGB there, and `WebGPURenderer` linear light, in which dark lines would be paler. */

/** The largest difference of mean greys, out of 255. Without a correction they differ by 1 to 6. */
const MOST_OFF_TONE = 0.3;
/** The same on a transparent canvas, where half of a contour has nothing to blend with. Without a correction they differ by 0.6 and 1.3. */
const MOST_OFF_TRANSPARENT = 0.8;

/** The group and the name of cases, and what they are drawn on. */
const CASES: readonly (readonly [group: string, name: string, background: string | null])[] = [
  ['outlines', 'a knot', '#ffffff'],
  ['outlines', 'a knot', null],
  ['outlines', 'chalk, by an unsteady hand', '#ffffff'],
  ['outlines', 'suggestive contours by an unsteady hand, blue, half opaque', '#ffffff'],
  ['scenes', 'the preset pen', '#f5f1e6'],
  ['scenes', 'the preset pen', null],
  ['scenes', 'the preset charcoal', '#f5f1e6'],
  ['scenes', 'the preset chalk', '#2a2d31'],
];

test('outlines of nodes are as dark as those in GLSL, also on a canvas', { tag: '@more' }, async ({ page }) => {
  for (const [group, name, background] of selected(CASES.slice(0, 1), CASES)) {
    const measured = await page.evaluate(([g, n, b]) => window.besideGlsl.measureOnCanvas(g, n, b), [
      group,
      name,
      background,
    ] as const);
    const { picture, tones, differing, covered } = measured;
    const path = test.info().outputPath(`${name.replace(/\W+/g, '-')}-${background ?? 'transparent'}.png`);
    writeFileSync(path, Buffer.from(picture.slice(picture.indexOf(',') + 1), 'base64'));
    const description = `mean greys ${tones.map((tone) => tone.toFixed(2)).join(' and ')}, ${(100 * differing).toFixed(3)} % of pixels differ`;
    test.info().annotations.push({ type: `${name}, ${background ?? 'transparent'}`, description });
    expect.soft(covered, `${name}: the share of pixels that are drawn`).toBeGreaterThan(0.05);
    expect
      .soft(Math.abs(tones[1] - tones[0]), `${name}, ${background}: ${description}`)
      .toBeLessThan(background === null ? MOST_OFF_TRANSPARENT : MOST_OFF_TONE);
  }
});
