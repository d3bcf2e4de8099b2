import type { Page } from '@playwright/test';
import { quickIf, quickOnly } from '../browser/quickIf.js';
import { expect, testOnOnePage } from '../browser/test.js';
import { compareWithGolden, type Picture } from './gate.js';
import { judgePicture } from './goldens.js';
import type { Deviation } from './renderScenario.js';
import { type Scenario, scenarios } from './scenarios.js';

const test = testOnOnePage('/tests/visual/scenario.html');

test.beforeEach(({ page }) => ready(page));

async function ready(page: Page): Promise<void> {
  await page.waitForFunction(() => typeof window.renderScenario === 'function', undefined, { timeout: 30_000 });
}

async function render(page: Page, scenario: Scenario, deviation?: Deviation): Promise<Picture> {
  const { width, height, base64 } = await page.evaluate(
    ([scenario, deviation]) => window.renderScenario(scenario, deviation),
    [scenario, deviation] as const,
  );
  return { width, height, data: Buffer.from(base64, 'base64') };
}

/** Names of pictures that together have each technique, model, layer and kind of stroke. */
const detailsOf = quickOnly(
  scenarios.map(({ name }) => name),
  [
    'figure-04-b-adjacency',
    'figure-08-blend-factors',
    'figure-09-toon',
    'figure-10-scale-coarse',
    'figure-12-crossHatching',
    'figure-13-without-blending',
    'flat-fox',
    'beyond-anchored-form',
    'beyond-crisp',
    'engraving-fixed',
    'layers-by-tone-anchored',
    'levels-floor-depth',
    'outlines-face',
  ],
);

test.describe('goldens', () => {
  for (const scenario of scenarios) {
    test(`${scenario.name}: ${scenario.sentence}`, detailsOf(scenario.name), async ({ page }, { annotations }) => {
      const { verdict, text } = judgePicture(scenario.name, await render(page, scenario));
      annotations.push({ type: 'gate', description: text });
      console.log(`  ${scenario.name}: ${text}`);
      expect(verdict, text).not.toBe('different');
    });
  }
});

test.describe('the gate itself', () => {
  const bunny = scenarios.find(({ name }) => name === 'figure-14-tangent')!;

  test('lets the same picture pass, rendered again, and again on a new page', { tag: '@all' }, async ({ page }) => {
    const first = await render(page, bunny);
    expect(compareWithGolden(await render(page, bunny), first).verdict).toBe('identical');
    await page.reload();
    await ready(page);
    expect(compareWithGolden(await render(page, bunny), first).verdict).toBe('identical');
  });

  test('redrawing the strokes unwidened is no deviation', { tag: '@all' }, async ({ page }) => {
    const golden = await render(page, bunny);
    expect(compareWithGolden(await render(page, bunny, { strokeWidth: 1 }), golden).verdict).toBe('identical');
  });

  for (const strokeWidth of [0.95, 1.05]) {
    test(`stops strokes of ${strokeWidth} times their width`, quickIf(strokeWidth === 1.05), async ({ page }) => {
      const golden = await render(page, bunny);
      const { verdict, text } = compareWithGolden(await render(page, bunny, { strokeWidth }), golden);
      console.log(`  strokes of ${strokeWidth} times their width: ${text}`);
      expect(verdict).toBe('different');
    });
  }

  test('stops strokes that are turned by one degree', { tag: '@all' }, async ({ page }) => {
    const golden = await render(page, bunny);
    const turned = { ...bunny, material: { ...bunny.material, strokeAngle: Math.PI / 180 } };
    expect(compareWithGolden(await render(page, turned), golden).verdict).toBe('different');
  });
});
