import { quickIf } from '../browser/quickIf.js';
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
  test(
    `a shadow has its tone at the contact and loses it evenly with the distance of a leaning board: ${filter}, ${kind}`,
    quickIf(['PCF, directional', 'Basic, point', 'VSM, spot'].includes(`${filter}, ${kind}`)),
    async ({ page }) => {
      const results = await page.evaluate(
        async ([filter, kind]) => {
          const { lightOf, casting, board, boardDistances, shadowGround, rendererOf, sceneOf, draw } = window.shading;
          const light = casting(await lightOf(kind), 1);
          // A bias moves the caster; only depths that are stored as halves need one.
          if (filter !== 'VSM') light.shadow.bias = 0;
          const plane = await shadowGround('triangle', { ink: '#000000', shadowTone: 0.5 }, true);
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
              // Beyond the end of the shadow, with a margin, the ground is blank.
              if (shadowFade * distance > 1.1) blank = Math.max(blank, tone);
            }
            return { shadowFade, count, worst, blank };
          });
        },
        [filter, kind] as const,
      );
      for (const { shadowFade, count, worst, blank } of results) {
        expect(count).toBeGreaterThan(3000);
        expect(worst, `shadowFade ${shadowFade}`).toBeLessThan(shadowFade === 0 ? 0.01 : 0.035);
        expect(blank, `shadowFade ${shadowFade}`).toBe(0);
      }
    },
  );
}

const STAGES = [0.9, 0.7, 0.5, 0.3, 0.1];
const DRAWN = ['engraving', 'pen', 'woodcut', 'hatching', 'dryMedia', 'stipple'] as const;

test('a shadow that dissolves has the tone that is left of it with all techniques of strokes and lines', async ({
  page,
}) => {
  const tones = await page.evaluate(
    async ([stages, techniques]) => {
      const { SIZE, lightOf, casting, plate, shadowGround, sceneOf, draw } = window.shading;
      const light = casting(await lightOf('directional'), 0);
      light.shadow.bias = 0;
      const height = 0.4;
      // The share of the tone that a fade of 1 takes there: the light's camera sees a width of 4.
      const share = height / light.position.clone().normalize().z / 4;
      const found: Record<string, number[]> = {};
      for (const technique of techniques) {
        const look = { ink: '#000000', shadowTone: 0.5, shadowDirection: 'away' } as const;
        const lines = { lineSpacing: 4, irregularity: 0.4, ...(technique !== 'engraving' && { strokeLength: 30 }) };
        const plane = await shadowGround(technique, {
          ...look,
          ...(['hatching', 'dryMedia', 'stipple'].includes(technique) ? { screenSpaceShare: 1 } : lines),
        });
        await plane.material.ready;
        const scene = sceneOf(plane, plate(height), light);
        found[technique] = stages.map((left) => {
          plane.material.shadowFade = (1 - left) / share;
          const pixels = draw(scene);
          let [sum, count] = [0, 0];
          for (let y = 0; y < SIZE; y++) {
            for (let x = Math.ceil(0.55 * SIZE); x < SIZE; x++) {
              sum += 1 - pixels[4 * (y * SIZE + x)] / 255;
              count++;
            }
          }
          return sum / count;
        });
      }
      return found;
    },
    [STAGES, DRAWN] as const,
  );
  for (const [technique, found] of Object.entries(tones)) {
    for (const [i, left] of STAGES.entries()) {
      expect(Math.abs(found[i] - 0.5 * left), `${technique}, ${left} is left: ${found}`).toBeLessThan(
        0.015 + 0.08 * left,
      );
    }
  }
});

test('lines of a woodcut end in points at the soft edge of a shadow, without isolated pieces', async ({ page }) => {
  const pieces = await page.evaluate(async () => {
    const { SIZE, lightOf, casting, plate, shadowGround, sceneOf, draw } = window.shading;
    const light = casting(await lightOf('directional'), 1);
    light.shadow.bias = 0;
    const plane = await shadowGround('woodcut', {
      ink: '#000000',
      shadowTone: 0.3,
      shadowFade: 0,
      shadowSoftness: 0.3,
      lineSpacing: 6,
      strokeLength: 60,
      irregularity: 0.6,
      screenSpaceShare: 1,
    });
    const pixels = draw(sceneOf(plane, plate(0.5), light));
    const isInk = (i: number): boolean => pixels[4 * i] < 190;
    const sizes: number[] = [];
    const seen = new Uint8Array(SIZE * SIZE);
    for (let first = 0; first < SIZE * SIZE; first++) {
      if (seen[first] || !isInk(first)) continue;
      const open = [first];
      seen[first] = 1;
      for (let n = 0; n < open.length; n++) {
        const [x, y] = [open[n] % SIZE, Math.floor(open[n] / SIZE)];
        for (let dy = -1; dy <= 1; dy++)
          for (let dx = -1; dx <= 1; dx++) {
            const next = (y + dy) * SIZE + x + dx;
            if (x + dx < 0 || x + dx >= SIZE || y + dy < 0 || y + dy >= SIZE || seen[next] || !isInk(next)) continue;
            seen[next] = 1;
            open.push(next);
          }
      }
      sizes.push(open.length);
    }
    return sizes.sort((a, b) => a - b);
  });
  expect(pieces.length).toBeGreaterThan(3);
  expect(pieces.filter((size) => size < 12).length, `${pieces}`).toBeLessThan(9);
});

const softMaps: [Filter, LightKind, boolean][] = [
  ...maps.map(([filter, kind]): [Filter, LightKind, boolean] => [filter, kind, false]),
  ['PCF', 'directional', true],
  ['PCF', 'point', true],
  ['Basic', 'spot', true],
  ['VSM', 'spot', true],
];

for (const [filter, kind, isReversed] of softMaps) {
  const depths = isReversed ? ', reversed depths' : '';
  test(
    `edges of a shadow are as wide as those of a round lamp at three heights, without bands: ${filter}, ${kind}${depths}`,
    quickIf(kind === 'point' && filter === 'PCF'),
    async ({ page }) => {
      const results = await page.evaluate(
        async ([filter, kind, isReversed]) => {
          const { SIZE, lightOf, casting, plate, plateVisibility, shadowGround, rendererOf, sceneOf, draw } =
            window.shading;
          const light = casting(await lightOf(kind), 1);
          light.position.x = -0.3;
          light.shadow.mapSize.setScalar(768);
          if (filter !== 'VSM') light.shadow.bias = 0;
          const shadowSoftness = 0.4;
          const renderer = rendererOf(filter, isReversed ? { reversedDepthBuffer: true } : {});
          const plane = await shadowGround('triangle', { ink: '#000000', shadowSoftness }, true);
          return [0.3, 0.6, 1].map((height) => {
            const pixels = draw(sceneOf(plane, plate(height), light), renderer);
            const drawn = Array.from({ length: SIZE }, (_, i) => pixels[4 * ((SIZE / 2) * SIZE + i)] / 255);
            return { height, drawn, cast: plateVisibility(kind, light, height, shadowSoftness) };
          });
        },
        [filter, kind, isReversed] as const,
      );
      for (const { height, drawn, cast } of results) {
        const [width, right] = [drawn, cast].map((row) => placeOf(row, 0.1) - placeOf(row, 0.9));
        expect(width / right, `height ${height}`).toBeGreaterThan(0.75);
        expect(width / right, `height ${height}`).toBeLessThan(1.25);
        // 24 places of a lamp: no step is of more than four of them beside the right one, and none goes back.
        const steps = (row: number[]) => row.slice(1).map((v, i) => row[i] - v);
        expect(Math.max(...steps(drawn)) - Math.max(...steps(cast)), `height ${height}`).toBeLessThan(0.125);
        expect(Math.min(...steps(drawn)), `height ${height}`).toBeGreaterThan(-0.02);
        expect(Math.max(...drawn.map((v, i) => Math.abs(v - cast[i]))), `height ${height}`).toBeLessThan(0.12);
      }
    },
  );
}

/** The pixel at which a row that falls from 1 to 0 crosses a value. */
function placeOf(row: number[], value: number): number {
  const after = row.findIndex((v) => v < value);
  return after - (value - row[after]) / (row[after - 1] - row[after]);
}

test('with light ink, whose tone falls with the light, a shadow alone is blank, its soft edge too', async ({
  page,
}) => {
  const printed = await page.evaluate(async () => {
    const { lightOf, casting, plate, shadowGround, sceneOf, draw } = window.shading;
    const light = casting(await lightOf('directional'), 1);
    const chalk = [
      [0, 0.95],
      [0.5, 0.6],
      [1, 0],
    ] as const;
    return Promise.all(
      ([chalk, 'linear'] as const).map(async (toneCurve) => {
        const look = { ink: '#000000', toneCurve, shadowTone: 1, shadowSoftness: 0.4 } as const;
        const pixels = draw(sceneOf(await shadowGround('triangle', look, true), plate(0.6), light));
        return 255 - pixels.reduce((least, value) => Math.min(least, value), 255);
      }),
    );
  });
  expect(printed[0]).toBe(0);
  expect(printed[1]).toBeGreaterThan(200);
});

for (const technique of ['hatching', 'engraving'] as const) {
  test(
    `strokes of a shadow alone run away from the light, whatever those of the model do: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const angles = await page.evaluate(async (technique) => {
        const { THREE, SIZE, lightOf, casting, clearances, ball, shadowGround, sceneOf, draw } = window.shading;
        const light = casting(await lightOf('directional'));
        const plane = await shadowGround(technique, {
          shadowTone: 0.4,
          shadowStrokes: 'cross',
          crossFrom: 0.1,
          ...(technique === 'engraving' ? { direction: 'x' } : { strokeLayers: 'tone', strokeAngle: 0.6 }),
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
    },
  );
}
