import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Outlines behind a surface that are drawn all the same, dashed or faint, as in technical drawings. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('the three hidden edges of a cube are dashed from corner to corner, or faint; visible edges do not change', async ({
  page,
}) => {
  const found = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, rendererOf, pixelOf, mostDifferent } =
      window.lining;
    const size = 500;
    const camera = lookFrom(2, 1.6, 3);
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1.4, 1.4, 1.4), { outlineWidth: 3, weights: { creases: 1 } });
    const { material } = outlinesOf(mesh);
    const scene = paperScene(mesh);
    const drawn = (hidden: 'none' | 'dashed' | 'faint') => {
      material.hidden = hidden;
      return draw(scene, camera, rendererOf(size));
    };
    const [none, dashed, faint] = [drawn('none'), drawn('dashed'), drawn('faint')];
    /** The ink added to the visible outlines. */
    const added = (ink: Float32Array) => ink.map((darkness, i) => darkness - none[i]);
    /** Ink along the way from the far corner to another, over the width of the line. */
    const profile = (ink: Float32Array, to: [number, number, number]) => {
      const from = pixelOf(new THREE.Vector3(-0.7, -0.7, -0.7), camera, size);
      const end = pixelOf(new THREE.Vector3(...to), camera, size);
      const length = Math.hypot(end.x - from.x, end.y - from.y);
      // The corners themselves are on other lines too.
      return Array.from({ length: Math.floor(length) - 16 }, (_, i) => {
        const t = (i + 8) / length;
        return ink[Math.floor(from.y + t * (end.y - from.y)) * size + Math.floor(from.x + t * (end.x - from.x))];
      });
    };
    const ends: [number, number, number][] = [
      [0.7, -0.7, -0.7],
      [-0.7, 0.7, -0.7],
      [-0.7, -0.7, 0.7],
    ];
    const mean = (values: number[]) => values.reduce((sum, one) => sum + one, 0) / values.length;
    const dashesOf = (values: number[]) => values.filter((one, i) => one > 0.4 && !(values[i - 1] > 0.4)).length;
    const again = drawn('none');
    const lost = none.reduce((most, ink, i) => Math.max(most, ink - dashed[i]), 0);
    return {
      dashed: ends.map((to) => mean(profile(added(dashed), to))),
      dashes: ends.map((to) => dashesOf(profile(added(dashed), to))),
      faint: ends.map((to) => mean(profile(added(faint), to))),
      mostFaint: Math.max(...ends.flatMap((to) => profile(added(faint), to))),
      back: mostDifferent(none, again),
      lost,
    };
  });
  // A dash is 3.5 widths long, a gap two.
  for (const ink of found.dashed) {
    expect(ink).toBeGreaterThan(0.45);
    expect(ink).toBeLessThan(0.75);
  }
  for (const dashes of found.dashes) expect(dashes).toBeGreaterThan(5);
  for (const ink of found.faint) expect(ink).toBeGreaterThan(0.2);
  expect(found.mostFaint).toBeLessThan(0.5);
  expect(found.back).toBe(0);
  expect(found.lost).toBeLessThan(0.02);
});

test('hidden contours of curved bodies are dashed, of instances too, whatever hides them', { tag: '@all' }, async ({
  page,
}) => {
  const found = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinedInstances, outlinesOf, paperScene, lookFrom, draw, rendererOf, total } =
      window.lining;
    const size = 500;
    const camera = lookFrom(0.4, 1.4, 3.2);
    const look = { outlineWidth: 2.4, hidden: 'dashed' } as const;
    const scenes = {
      torus: paperScene(await outlinedMesh(new THREE.TorusGeometry(0.9, 0.34, 48, 96).rotateX(1.2), look)),
      rings: paperScene(
        await outlinedInstances(
          new THREE.TorusGeometry(0.5, 0.2, 32, 64).rotateX(1.2),
          [-0.5, 0.5].map((x) => new THREE.Matrix4().makeTranslation(x, 0, -x)),
          look,
        ),
      ),
      'a sphere behind a plate': paperScene(
        await outlinedMesh(new THREE.SphereGeometry(0.6, 48, 32).translate(0, 0, -0.8), look),
        new THREE.Mesh(new THREE.BoxGeometry(2.4, 2.4, 0.05), new THREE.MeshBasicMaterial({ color: 'white' })),
      ),
    };
    return Object.entries(scenes).map(([name, scene]) => {
      const inks = (['none', 'dashed', 'none'] as const).map((hidden) => {
        scene.traverse((object) => {
          if ('isHatchingOutlines' in object) outlinesOf(object.parent!).material.hidden = hidden;
        });
        return total(draw(scene, camera, rendererOf(size)));
      });
      return { name, inks };
    });
  });
  for (const { name, inks } of found) {
    expect(inks[1], name).toBeGreaterThan(inks[0] + 40);
    expect(inks[2], name).toBe(inks[0]);
  }
  // A sphere wholly behind a plate shows only its dashes.
  expect(found[2].inks[0]).toBeLessThan(1);
});

test('a wrong value is refused in one sentence', async ({ page }) => {
  const message = await page.evaluate(() => {
    try {
      new window.lining.HatchingOutlineMaterial({ hidden: 'dotted' as 'dashed' });
    } catch (error) {
      return (error as Error).message;
    }
    return '';
  });
  expect(message).toBe("HatchingOutlineMaterial.hidden is dotted, but must be 'none', 'dashed', 'faint'.");
});
