import { writeFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { expect, testOnOnePage } from '../browser/test.js';
import type { HatchingSpec } from '../gpu/hatchingSpec.js';
import { cases as selected } from '../selection.mjs';
import { type Comparison, NOTICEABLE } from './picturesOf.js';
import type { SceneCase } from './SceneCase.js';

/** Tests on the page that draws scenes in GLSL and of nodes. */
export const test = testOnOnePage('tests/webgpu/sideBySide.html', {
  begin: (page) => page.waitForFunction(() => window.besideGlsl !== undefined),
});

/** The largest difference of mean tones, out of 255, where pixels are not compared. */
const MOST_OFF_TONE = 0.2;

/** The largest share of pixels that may differ noticeably, by default. */
const MOST_DIFFERING = 0.0005;

type Backend = 'forceWebGL' | 'webgpu';

/**
 * How a test of a list of cases begins: with the cases that are selected. Both backends build their programs from the same nodes, so that each
 * draws every second case, and those that are named. WebGL 2 also draws those whose pixels WebGPU is not held to, and all of them where the
 * browser has no WebGPU.
 */
async function begin<Case extends Pick<SceneCase, 'name' | 'onWebGPU'>>(
  page: Page,
  drawn: Backend,
  all: readonly Case[],
  quick: readonly string[],
): Promise<readonly Case[]> {
  const named = all.filter(({ name }) => quick.includes(name));
  expect(named.length, 'cases that are named').toBe(quick.length);
  const lack = await page.evaluate(() => window.besideGlsl.lackOfWebGPU);
  test.skip(drawn === 'webgpu' && lack !== null, lack ?? '');
  const drawnHere = all.filter((each, i) => {
    const isTheirs = drawn === 'webgpu' ? i % 2 === 0 : i % 2 === 1 || each.onWebGPU === 'tone' || lack !== null;
    return isTheirs || named.includes(each);
  });
  const cases = selected(named, drawnHere);
  expect(cases.length, 'cases that are drawn').toBeGreaterThan(0);
  // Each case builds its own programs, on the processor.
  test.setTimeout(Math.max(300_000, 30_000 * cases.length));
  return cases;
}

/** @param most the largest share of pixels that may differ noticeably; null where only the mean tones are compared */
function expectAlike({ differing, tones, covered, colours }: Comparison, name: string, most: number | null): void {
  const description = `${(100 * differing).toFixed(3)} % of pixels off by more than ${NOTICEABLE}, mean tones ${tones.map((tone) => tone.toFixed(2)).join(' and ')}`;
  test.info().annotations.push({ type: name, description });
  expect.soft(covered, `${name}: the share of pixels that are drawn`).toBeGreaterThan(0.05);
  expect.soft(colours, `${name}: a picture of background, ink and paper`).toBeGreaterThan(2);
  if (most === null) {
    expect.soft(Math.abs(tones[1] - tones[0]), `${name}: mean tones`).toBeLessThanOrEqual(MOST_OFF_TONE);
  } else {
    expect.soft(differing, `${name}: ${description}`).toBeLessThanOrEqual(most);
  }
}

const tagOf = (drawn: Backend, quick: readonly string[]): string =>
  drawn === 'forceWebGL' && quick.length > 0 ? '@more' : '@all';

/**
 * Declares the tests of a file of `cases`: nodes draw what GLSL draws, half of the cases with the WebGL 2 backend and half with WebGPU,
 * where the browser has it. The annotations of tests/output/playwright.json have the measures. The pictures lie beside it: GLSL, nodes, and their
 * difference times four.
 *
 * @param quick the names of the cases that `npm test` draws, with the WebGL 2 backend alone. Default: none
 */
export function testGroup(group: string, quick: readonly string[] = []): void {
  for (const drawn of ['forceWebGL', 'webgpu'] as const) {
    test(`${group}: nodes draw what GLSL draws, ${drawn}`, { tag: tagOf(drawn, quick) }, async ({ page }) => {
      const all = await page.evaluate((g) => window.besideGlsl.casesOf(g), group);
      expect(all.length, `cases of ${group}`).toBeGreaterThan(0);
      for (const { name, onWebGPU, most = MOST_DIFFERING } of await begin(page, drawn, all, quick)) {
        const measured = await page.evaluate(([g, n, d]) => window.besideGlsl.measure(g, n, d), [
          group,
          name,
          drawn,
        ] as const);
        const { picture } = measured;
        const path = test.info().outputPath(`${name.replace(/\W+/g, '-')}.png`);
        writeFileSync(path, Buffer.from(picture.slice(picture.indexOf(',') + 1), 'base64'));
        expectAlike(measured, name, drawn === 'webgpu' && onWebGPU === 'tone' ? null : most);
      }
    });
  }
}

/**
 * Declares the tests of the scenes in which GLSL is compared with the reference in double precision: nodes draw what GLSL draws, so that
 * they need no comparison of their own.
 *
 * @param quick as in {@link testGroup}
 * @param drawnInCases the names of scenes that a file of `cases` draws too; they are skipped here
 */
export function testSpecs(
  kind: string,
  specs: ReadonlyMap<string, HatchingSpec>,
  { quick, drawnInCases }: { quick: readonly string[]; drawnInCases: readonly string[] },
): void {
  const missing = drawnInCases.filter((name) => !specs.has(name));
  if (missing.length > 0) throw new Error(`testSpecs: no scene of ${kind} is named ${missing.join('; ')}.`);
  for (const drawn of ['forceWebGL', 'webgpu'] as const) {
    const title = `${kind} in scenes of the reference: nodes draw what GLSL draws, ${drawn}`;
    test(title, { tag: tagOf(drawn, quick) }, async ({ page }) => {
      const all = [...specs].filter(([name]) => !drawnInCases.includes(name)).map(([name, spec]) => ({ name, spec }));
      for (const { name, spec } of await begin(page, drawn, all, quick)) {
        const measured = await page.evaluate(([n, s, d]) => window.besideGlsl.measureSpec(n, s, d), [
          `${kind}: ${name}`,
          spec,
          drawn,
        ] as const);
        expectAlike(measured, name, MOST_DIFFERING);
      }
    });
  }
}
