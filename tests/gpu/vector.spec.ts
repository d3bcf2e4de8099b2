import { quickIf } from '../browser/quickIf.js';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Drawings that leave as lines, beside the canvas and in a browser. */

const test = onOnePage('tests/gpu/vector.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.vectors !== undefined);
});

for (const [model, drawing] of [
  ['torus', {}],
  ['torus', { isOrthographic: true, light: [0.8, 0.5, 0.6] }],
  ['bunny', {}],
  ['bunny', { hasShadows: true, light: [0.9, 0.7, 0.5] }],
  ['dragon11k', { preset: 'banknote' }],
  ['sphere', { preset: 'stipple' }],
  ['torus', { preset: 'pen', light: [0.9, 0.7, 0.5] }],
  ['bunny', { preset: 'woodcut' }],
] as const) {
  test(
    `a ${model} is drawn as on the canvas: ${JSON.stringify(drawing)}`,
    quickIf('preset' in drawing && drawing.preset === 'woodcut'),
    async ({ page }) => {
      const { mean, p99, ink } = await page.evaluate(
        async ([model, drawing]) => window.vectors.compareLines(await window.vectors.loadModel(model), drawing),
        [model, drawing] as const,
      );
      expect(mean).toBeLessThan(0.012);
      expect(p99).toBeLessThan(0.045);
      expect(ink).toBeGreaterThan(0.985);
      expect(ink).toBeLessThan(1.015);
    },
  );
}

test('a ball of half opacity before a torus is drawn as on the canvas', { tag: '@all' }, async ({ page }) => {
  const { mean, p99, ink } = await page.evaluate(async () => {
    const { THREE, compareScene, comparedScene, loadModel } = window.vectors;
    const { scene, camera } = await comparedScene(await loadModel('torus'), {});
    const torus = scene.children.find((child) => 'isMesh' in child) as InstanceType<typeof THREE.Mesh>;
    const ball = await window.toolkit.hatchedMesh(new THREE.SphereGeometry(0.55, 64, 48), { technique: 'engraving' });
    ball.material = (torus.material as typeof ball.material).clone();
    ball.material.setValues({ transparent: true, opacity: 0.5 });
    ball.position.set(0.45, 0.1, 0.95);
    scene.add(ball);
    return compareScene(scene, camera);
  });
  expect(mean).toBeLessThan(0.012);
  expect(p99).toBeLessThan(0.045);
  expect(ink).toBeGreaterThan(0.985);
  expect(ink).toBeLessThan(1.015);
});

test('a torus of smooth metal is drawn as on the canvas', async ({ page }) => {
  const { mean, p99, ink, change } = await page.evaluate(async () => {
    const { THREE, compareScene, comparedScene, drawSVG, loadModel } = window.vectors;
    const { scene, camera } = await comparedScene(await loadModel('torus'), {});
    const torus = scene.children.find((child) => 'isMesh' in child) as InstanceType<typeof THREE.Mesh>;
    const material = torus.material as Awaited<ReturnType<typeof window.toolkit.hatchedMesh>>['material'];
    const length = async (): Promise<number> =>
      (await drawSVG(scene, camera, { sheet: [100, 100], margin: 5 })).svg.length;
    const before = await length();
    material.setValues({ metalness: 1, roughness: 0.2 });
    await material.ready;
    return { ...(await compareScene(scene, camera)), change: (await length()) / before };
  });
  expect(Math.abs(change - 1)).toBeGreaterThan(0.05);
  expect(mean).toBeLessThan(0.012);
  expect(p99).toBeLessThan(0.045);
  expect(ink).toBeGreaterThan(0.985);
  expect(ink).toBeLessThan(1.015);
});

for (const kind of ['print', 'pen'] as const) {
  test(
    `an animated ${kind} draws itself path by path, ends as the still one, and stands still for whoever wants less motion`,
    quickIf(kind === 'print'),
    async ({ page }) => {
      const { animated, still, drawn } = await page.evaluate(async (kind) => {
        const { comparedScene, drawSVG, loadModel } = window.vectors;
        const { scene, camera } = await comparedScene(await loadModel('torus'), {});
        const options = { kind, sheet: [100, 100] as const, margin: 5 };
        const still = await drawSVG(scene, camera, options);
        const animated = await drawSVG(scene, camera, { ...options, animate: 4 });
        return { animated: animated.svg, still: still.svg, drawn: animated.paths };
      }, kind);
      expect(drawn).toBeGreaterThan(100);
      const showAt = (svg: string, time: number | null) =>
        page.evaluate(
          async ([svg, time]) => {
            document.body.innerHTML = svg;
            const animations = document.getAnimations();
            for (const animation of animations) {
              animation.pause();
              animation.currentTime = time;
            }
            return animations.length;
          },
          [svg, time] as const,
        );
      /** Mean darkness of the page. */
      const darkness = async (): Promise<number> => {
        const data = (await page.locator('svg').screenshot()).toString('base64');
        return page.evaluate(async (data) => {
          const image = new Image();
          image.src = `data:image/png;base64,${data}`;
          await image.decode();
          const canvas = document.createElement('canvas');
          [canvas.width, canvas.height] = [image.width, image.height];
          const context = canvas.getContext('2d')!;
          context.drawImage(image, 0, 0);
          return context.getImageData(0, 0, image.width, image.height).data.reduce((sum, one) => sum + 255 - one, 0);
        }, data);
      };
      await page.emulateMedia({ reducedMotion: 'no-preference' });
      expect(await showAt(still, null)).toBe(0);
      const whole = await darkness();
      // Every path has a motion of its own.
      expect(await showAt(animated, 1e6)).toBe(drawn);
      expect(Math.abs((await darkness()) / whole - 1)).toBeLessThan(0.003);
      const shares = [];
      for (const time of [0, 1000, 2000, 3000, 5000]) {
        await showAt(animated, time);
        shares.push(await darkness());
      }
      expect(shares[0]).toBe(0);
      for (let i = 1; i < shares.length; i++) expect(shares[i]).toBeGreaterThan(shares[i - 1]);
      expect(shares[2] / shares[4]).toBeGreaterThan(0.2);
      expect(shares[2] / shares[4]).toBeLessThan(0.8);
      await page.emulateMedia({ reducedMotion: 'reduce' });
      expect(await showAt(animated, null)).toBe(0);
      expect(Math.abs((await darkness()) / whole - 1)).toBeLessThan(0.003);
      await page.emulateMedia({ reducedMotion: null });
      await page.evaluate(() => {
        document.body.innerHTML = '';
      });
    },
  );
}
