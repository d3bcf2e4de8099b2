import { expect, testOnOnePage as onOnePage } from '../browser/test.js';
import type { Filter, LightKind } from './shadows.js';
import { techniques } from './techniques.js';

/** Shadows under every kind of light: where they end, how dark they are, and what strokes do in them. */

const test = onOnePage('tests/gpu/shadows.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.shading !== undefined);
});

const shadowStrokes = ['tone', 'cross', 'reorient'] as const;

const outlines: [Filter, LightKind][] = [
  ...(['directional', 'spot', 'point', 'point over a seam', 'sun'] as const).flatMap((kind) =>
    (['PCF', 'Basic'] as const).map((filter): [Filter, LightKind] => [filter, kind]),
  ),
  ['VSM', 'directional'],
  ['VSM', 'spot'],
  ['VSM', 'sun'],
];

for (const [filter, kind] of outlines) {
  test(`the outline of a ball's shadow is the ellipse, to 1.5 texels, without stairs: ${filter}, ${kind}`, async ({
    page,
  }) => {
    const { wrong, inside, steepest, twice } = await page.evaluate(
      async ([filter, kind]) => {
        const { SIZE, lightOf, casting, clearances, ball, ground, rendererOf, sceneOf, draw } = window.shading;
        const light = casting(await lightOf(kind));
        const plane = await ground('triangle', {}, true);
        const scene = sceneOf(plane, ball(), light);
        const shadowed = draw(scene, rendererOf(filter));
        const far = clearances(kind, light);
        plane.receiveShadow = false;
        const lit = draw(scene, rendererOf(filter));
        const share = far.map((_, i) => shadowed[4 * i] / lit[4 * i]);
        const wrong: number[] = [];
        let inside = 0;
        let steepest = 0;
        let texels = 0;
        for (let i = 0; i < far.length; i++) {
          if (far[i] < 0) inside++;
          if (far[i] < -1.5 ? share[i] > 0.01 : far[i] > 1.5 && share[i] < 0.99) wrong.push(far[i]);
          if (i % SIZE === 0 || i < SIZE) continue;
          steepest = Math.max(steepest, Math.abs(share[i] - share[i - 1]), Math.abs(share[i] - share[i - SIZE]));
          if (Math.abs(far[i]) < 8) texels = Math.max(texels, Math.hypot(far[i] - far[i - 1], far[i] - far[i - SIZE]));
        }
        return { wrong, inside, steepest, twice: 1 / texels };
      },
      [filter, kind] as const,
    );
    expect(inside).toBeGreaterThan(4000);
    console.log(filter, kind, { wrong:wrong.length, inside, steepest, pixelsPerTexel: twice });
    expect(wrong).toEqual([]);
    // A step from lit to shadowed takes more than a pixel where a texel does.
    if (filter !== 'VSM') expect(steepest).toBeLessThan(0.95);
  });
}
