import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Outlines of many small parts, which thin where they crowd. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('the ink of outlines that crowd is bounded in every block, and changes little by little with the distance', async ({
  page,
}) => {
  const seen = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, pixelOf, strips } = window.lining;
    const scene = paperScene(await outlinedMesh(strips(80)));
    const [size, block] = [400, 24];
    const found: { most: number; mean: number }[] = [];
    for (let away = 1.2; away < 12; away *= 1.1) {
      const camera = lookFrom(0, 0, away);
      const ink = draw(scene, camera);
      const low = pixelOf(new THREE.Vector3(-0.88, 0.85, 0), camera, size);
      const high = pixelOf(new THREE.Vector3(0.58, -0.85, 0), camera, size);
      const inks: number[] = [];
      for (let y = Math.ceil(Math.max(low.y, 0)); y + block <= Math.min(high.y, size); y += block / 2) {
        for (let x = Math.ceil(Math.max(low.x, 0)); x + block <= Math.min(high.x, size); x += block / 2) {
          let sum = 0;
          for (let j = 0; j < block; j++) for (let i = 0; i < block; i++) sum += ink[(y + j) * size + x + i];
          inks.push(sum / block ** 2);
        }
      }
      found.push({ most: Math.max(...inks), mean: inks.reduce((sum, one) => sum + one, 0) / inks.length });
    }
    return found;
  });
  const means = seen.map(({ mean }) => mean);
  expect(Math.max(...seen.map(({ most }) => most))).toBeLessThan(0.4);
  // Far away only their tone is left; near by they have their whole width.
  expect(means.at(-1)).toBeLessThan(0.02);
  expect(Math.max(...means)).toBeGreaterThan(0.2);
  expect(Math.max(...means.slice(1).map((mean, i) => Math.abs(mean - means[i])))).toBeLessThan(0.06);
});

test('the outline of a part that stands alone is as wide as that of a body without others', async ({ page }) => {
  const [beside, alone] = await page.evaluate(async () => {
    const { outlinedMesh, paperScene, lookFrom, draw, strips, loneStrip } = window.lining;
    const inkOf = async (source: ReturnType<typeof strips>) => {
      const ink = draw(paperScene(await outlinedMesh(source)), lookFrom(0, 0, 2.9));
      // The rightmost quarter, where the crowd is not.
      return ink.reduce((sum, one, i) => (i % 400 >= 340 ? sum + one : sum), 0);
    };
    return [await inkOf(strips(80)), await inkOf(loneStrip(80))];
  });
  expect(alone).toBeGreaterThan(1000);
  expect(beside / alone).toBeCloseTo(1, 2);
});
