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
    const { wrong, inside, steepest, pixelsPerTexel } = await page.evaluate(
      async ([filter, kind]) => {
        const { SIZE, lightOf, casting, clearances, ball, ground, rendererOf, sceneOf, draw } = window.shading;
        const light = casting(await lightOf(kind));
        const plane = await ground('triangle', {}, true);
        const scene = sceneOf(plane, ball(), light);
        const shadowed = draw(scene, rendererOf(filter));
        const away = clearances(kind, light);
        plane.receiveShadow = false;
        const lit = draw(scene, rendererOf(filter));
        const share = away.map((_, i) => shadowed[4 * i] / lit[4 * i]);
        const wrong = away.filter((d, i) => (d < -1.5 ? share[i] > 0.01 : d > 1.5 && share[i] < 0.99)).length;
        let steepest = 0;
        let texels = 0;
        for (let i = 0; i < away.length; i++) {
          if (i % SIZE === 0 || i < SIZE || Math.abs(away[i]) > 3) continue;
          steepest = Math.max(steepest, Math.abs(share[i] - share[i - 1]), Math.abs(share[i] - share[i - SIZE]));
          texels = Math.max(texels, Math.abs(away[i] - away[i - 1]), Math.abs(away[i] - away[i - SIZE]));
        }
        return { wrong, inside: away.filter((d) => d < 0).length, steepest, pixelsPerTexel: 1 / texels };
      },
      [filter, kind] as const,
    );
    expect(inside).toBeGreaterThan(4000);
    expect(wrong).toBe(0);
    // From lit to shadowed the mean of four texels goes over a texel, more steeply only where its cells meet.
    if (filter !== 'VSM') expect(steepest).toBeLessThan(Math.min(1.4 / pixelsPerTexel, 0.95));
  });
}

for (const kind of ['directional', 'spot', 'point', 'sun'] as const) {
  test(`soft edges are as wide as asked, rise evenly, and belong to the ground, not to the screen: ${kind}`, async ({
    page,
  }) => {
    const { moved, widths, falls } = await page.evaluate(async (kind) => {
      const { SIZE, lightOf, casting, clearances, ball, ground, rendererOf, sceneOf, draw, above } = window.shading;
      const light = casting(await lightOf(kind), 3);
      const plane = await ground('triangle', {}, true);
      const scene = sceneOf(plane, ball(), light);
      const renderer = rendererOf();
      const [right, up] = [17, -6];
      const straight = draw(scene, renderer);
      const aside = draw(scene, renderer, above(right, up));
      let moved = 0;
      for (let y = 6; y < SIZE; y++) {
        for (let x = 17; x < SIZE; x++) {
          const there = (y - up) * SIZE + x - right;
          if (y - up >= SIZE) continue;
          // The cascades of a sun follow the camera, and its texels with them.
          moved = Math.max(moved, Math.abs(straight[4 * (y * SIZE + x)] - aside[4 * there]));
        }
      }
      const widths = [1, 3].map((radius) => {
        light.shadow.radius = radius;
        const soft = draw(scene, renderer);
        plane.receiveShadow = false;
        const lit = draw(scene, renderer);
        plane.receiveShadow = true;
        const away = clearances(kind, light);
        return away.filter((_, i) => soft[4 * i] > 0.05 * lit[4 * i] && soft[4 * i] < 0.95 * lit[4 * i]).length;
      });
      // Along a row from the middle of the shadow outwards it only grows lighter.
      light.shadow.radius = 3;
      const soft = draw(scene, renderer);
      const away = clearances(kind, light);
      const middle = away.indexOf(Math.min(...away));
      let falls = 0;
      for (let i = middle + 1; i % SIZE !== 0 && away[i] < 8; i++)
        falls = Math.max(falls, soft[4 * i - 4] - soft[4 * i]);
      return { moved, widths, falls };
    }, kind);
    if (kind !== 'sun') expect(moved).toBeLessThanOrEqual(1);
    expect(widths[1] / widths[0]).toBeGreaterThan(1.5);
    expect(falls).toBeLessThanOrEqual(2);
  });
}

for (const technique of techniques) {
  test(`outside a shadow no stroke changes, and inside the tone is that of the other lights: ${technique}`, async ({
    page,
  }) => {
    const results = await page.evaluate(
      async ([technique, shadowStrokes]) => {
        const { lightOf, casting, clearances, ball, ground, sceneOf, draw, compared } = window.shading;
        const light = casting(await lightOf('directional', 1.8));
        const rest = await lightOf('point', 1.1);
        const plane = await ground(technique);
        const grey = await ground('triangle', {}, true);
        const away = clearances('directional', light);
        const scene = sceneOf(plane, ball(), light, rest);
        const greyScene = sceneOf(grey, ball(), light.clone(), rest.clone());
        return shadowStrokes.map((choice) => {
          plane.material.shadowStrokes = choice;
          grey.material.shadowStrokes = choice;
          plane.receiveShadow = true;
          const shadowed = draw(scene);
          const shadowedGrey = draw(greyScene);
          plane.receiveShadow = false;
          const lit = draw(scene);
          light.intensity = 0;
          greyScene.children[2].visible = false;
          const without = draw(scene);
          const withoutGrey = draw(greyScene);
          light.intensity = 1.8;
          greyScene.children[2].visible = true;
          return {
            choice,
            outside: compared(shadowed, lit, (i) => away[i] > 2.5),
            inside: compared(shadowed, without, (i) => away[i] < -2.5),
            grey: compared(shadowedGrey, withoutGrey, (i) => away[i] < -2.5),
          };
        });
      },
      [technique, shadowStrokes] as const,
    );
    for (const { choice, outside, inside, grey } of results) {
      console.log(technique, choice, JSON.stringify({ outside, inside, grey }));
      expect(outside.count).toBeGreaterThan(10_000);
      expect(outside.most, choice).toBe(0);
      expect(grey.count).toBeGreaterThan(2000);
      expect(grey.most, choice).toBeLessThanOrEqual(2);
      // Of a few strokes the mean is what it happens to be.
      expect(Math.abs(inside.means[0] - inside.means[1]), choice).toBeLessThan(0.04);
    }
  });
}

for (const technique of ['anchored', 'engraved'] as const) {
  for (const blocked of ['directional', 'spot', 'point', 'sun'] as const) {
    test(`strokes turn to the lights that arrive: ${technique}, a shadow of ${blocked} among four lights`, async ({
      page,
    }) => {
      const results = await page.evaluate(
        async ([technique, blocked]) => {
          const { lightOf, casting, clearances, ball, ground, sceneOf, draw, compared } = window.shading;
          const places = {
            directional: [2, 0, 1.5],
            spot: [0, 2.4, 2],
            point: [-1.8, -0.5, 2],
            sun: [-1, -2, 2],
          } as const;
          const lights = await Promise.all(
            (['directional', 'spot', 'point', 'sun'] as const).map(async (kind) => {
              // Brightest of all, so that where it does not arrive the others have another mean.
              const light = await lightOf(kind, kind === blocked ? 2 : 0.35);
              if (kind === blocked) casting(light);
              else light.position.set(...places[kind]);
              return light;
            }),
          );
          const plane = await ground(technique, { shadowStrokes: 'reorient' });
          const scene = sceneOf(plane, ball(), ...lights);
          const light = lights.find(({ castShadow }) => castShadow)!;
          const shadowed = draw(scene);
          const away = clearances(blocked, light);
          const isInside = (i: number) => away[i] < -2.5;
          plane.material.shadowStrokes = 'tone';
          const darkened = draw(scene);
          light.intensity = 0;
          const without = draw(scene);
          return {
            turned: compared(shadowed, without, isInside),
            darkened: compared(darkened, without, isInside),
          };
        },
        [technique, blocked] as const,
      );
      console.log(technique, blocked, JSON.stringify(results));
      expect(results.turned.share).toBeLessThan(0.01);
      // Strokes that had not turned would lie elsewhere.
      expect(results.darkened.share).toBeGreaterThan(0.15);
    });
  }
}
