import { expect, testOnOnePage as onOnePage } from '../browser/test.js';
import type { Filter, LightKind } from './shadows.js';

/** Shadows alone, on a ground: how dark they are where they touch their caster, how they dissolve, and which way their strokes run. */

const test = onOnePage('tests/gpu/shadows.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.shading !== undefined);
});

const maps: [Filter, LightKind][] = [
  ...(['directional', 'spot', 'point'] as const).flatMap((kind) =>
    (['PCF', 'Basic'] as const).map((filter): [Filter, LightKind] => [filter, kind]),
  ),
  ['VSM', 'directional'],
  ['VSM', 'spot'],
];

for (const [filter, kind] of maps) {
  test(`a shadow has its tone at the contact and loses it evenly with the distance of a leaning board: ${filter}, ${kind}`, async ({
    page,
  }) => {
    const results = await page.evaluate(
      async ([filter, kind]) => {
        const { lightOf, casting, board, boardDistances, ground, rendererOf, sceneOf, draw } = window.shading;
        const light = casting(await lightOf(kind), 1);
        // A bias moves the caster; only depths that are stored as halves need one.
        if (filter !== 'VSM') light.shadow.bias = 0;
        const plane = await ground('triangle', { toneModel: 'shadow', ink: '#000000', shadowTone: 0.5 }, true);
        const scene = sceneOf(plane, board(), light);
        const distances = boardDistances(kind, light);
        return [0, 1, 4].map((shadowFade) => {
          plane.material.shadowFade = shadowFade;
          const pixels = draw(scene, rendererOf(filter));
          let [count, worst, blank] = [0, 0, 0];
          for (const [i, distance] of distances.entries()) {
            if (Number.isNaN(distance)) continue;
            const left = Math.max(1 - shadowFade * distance, 0);
            const tone = 1 - pixels[4 * i] / 255;
            count++;
            worst = Math.max(worst, Math.abs(tone - 0.5 * left));
            // Where nothing should be left, with a margin, nothing is printed.
            if (shadowFade * distance > 1.1) blank = Math.max(blank, tone);
          }
          return { shadowFade, count, worst, blank };
        });
      },
      [filter, kind] as const,
    );
    for (const { shadowFade, count, worst, blank } of results) {
      expect(count).toBeGreaterThan(3000);
      expect(worst, `shadowFade ${shadowFade}`).toBeLessThan(shadowFade === 0 ? 0.01 : 0.03);
      expect(blank, `shadowFade ${shadowFade}`).toBe(0);
    }
  });
}

for (const technique of ['anchored', 'engraved'] as const) {
  test(`strokes of a shadow alone run away from the light, whatever those of the model do: ${technique}`, async ({
    page,
  }) => {
    const angles = await page.evaluate(async (technique) => {
      const { THREE, SIZE, lightOf, casting, clearances, ball, ground, sceneOf, draw } = window.shading;
      const light = casting(await lightOf('directional'));
      const plane = await ground(technique, {
        toneModel: 'shadow',
        shadowTone: 0.4,
        shadowStrokes: 'cross',
        crossFrom: 0.1,
        ...(technique === 'engraved' ? { lineField: 'x' } : { strokeLayers: 'tone', strokeRotation: 0.6 }),
      });
      const scene = sceneOf(plane, ball(), light);
      return (['away', 'strokes'] as const).map((shadowDirection) => {
        plane.material.shadowDirection = shadowDirection;
        const pixels = draw(scene);
        const away = clearances('directional', light);
        // The mean of gradients as directions of the doubled angle: strokes lie across it.
        const tensor = new THREE.Vector2();
        let sum = 0;
        for (let i = SIZE; i < away.length - SIZE; i++) {
          if (away[i] > -3) continue;
          const x = pixels[4 * (i + 1)] - pixels[4 * (i - 1)];
          const y = pixels[4 * (i + SIZE)] - pixels[4 * (i - SIZE)];
          tensor.x += x * x - y * y;
          tensor.y += 2 * x * y;
          sum += x * x + y * y;
        }
        const strokes = Math.atan2(tensor.y, tensor.x) / 2 + Math.PI / 2;
        const from = Math.atan2(light.position.y, light.position.x);
        return { off: Math.abs(Math.sin(strokes - from)), coherence: tensor.length() / sum };
      });
    }, technique);
    const [away, strokes] = angles;
    expect(away.off).toBeLessThan(Math.sin(0.1));
    expect(away.coherence).toBeGreaterThan(0.85);
    expect(strokes.off).toBeGreaterThan(0.3);
  });
}
