import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

test('outlines of a surface are thinner with its depth, and heavier in front than without a fade', async ({ page }) => {
  const { inks, programs } = await page.evaluate(async () => {
    const { THREE, applyHatching, makeRenderer, pixelsOf, sceneOf, SIZE } = window.toolkit;
    // Sheets at depths of 2, 4 and 10, whose upper and lower borders are off the picture.
    const sheets = [2, 4, 10].map((depth, i) => {
      const sheet = new THREE.Mesh(new THREE.PlaneGeometry(0.5, 4), new THREE.MeshBasicMaterial());
      sheet.position.set(i - 1, 0, -depth);
      return sheet;
    });
    const root = new THREE.Group().add(...sheets);
    const camera = new THREE.OrthographicCamera(-1.5, 1.5, 1.5, -1.5, 0.1, 50);
    const hatched = await applyHatching(root, {
      material: { technique: 'engraved' },
      outlines: { outlineWidth: 2, shadeWeights: [1, 1] },
    });
    // So lit, the sheets are blank.
    const scene = sceneOf(root, new THREE.AmbientLight('white', 2 * Math.PI));
    scene.background = new THREE.Color('white');
    const renderer = makeRenderer();
    const inks = [0, 0.5, 1].map((depthFade) => {
      for (const one of hatched.materials) Object.assign(one, { depthFade });
      const pixels = pixelsOf(scene, renderer, camera);
      // Two borders a sheet, from the bottom to the top of the picture.
      return sheets.map((_, i) => {
        let ink = 0;
        for (let p = 0; p < SIZE * SIZE; p++)
          if (Math.floor(((p % SIZE) * 3) / SIZE) === i) ink += 1 - pixels[4 * p] / 255;
        return ink / (2 * SIZE);
      });
    });
    return { inks, programs: renderer.info.programs!.length };
  });
  // The front lies at the near end of the fade, the last sheet at its far end, and the one between a quarter of the way.
  const air = (1 - Math.exp(-3 / 4)) / (1 - Math.exp(-3));
  for (const [i, fade] of [0, 0.5, 1].entries()) {
    const widths = [0, air, 1].map((share) => 2 * (1 - fade * share + 0.4 * fade * (1 - share)));
    for (const [k, width] of widths.entries()) expect(inks[i][k], `fade ${fade}, sheet ${k}`).toBeCloseTo(width, 1);
  }
  expect(programs).toBe(2);
});

test('a scene that is deep fades by itself, another one does not', async ({ page }) => {
  const ink = await page.evaluate(async () => {
    const { THREE, applyHatching, makeRenderer, pixelsOf, sceneOf } = window.toolkit;
    const renderer = makeRenderer();
    const draw = async (length: number, depthFade: number | 'auto') => {
      const floor = new THREE.Mesh(new THREE.PlaneGeometry(40, length), new THREE.MeshBasicMaterial());
      floor.rotation.x = -Math.PI / 2;
      floor.position.set(0, -1, -2 - length / 2);
      const root = new THREE.Group().add(floor);
      const hatched = await applyHatching(root, {
        material: { technique: 'engraved', toneCurve: 'linear', depthFade },
      });
      const pixels = pixelsOf(sceneOf(root), renderer, new THREE.PerspectiveCamera(40, 1, 0.1, 100));
      hatched.dispose();
      // Without a light the floor is black, before a green ground.
      return pixels.reduce((sum, value, i) => sum + (i % 4 === 1 ? 255 - value : 0), 0) / 255;
    };
    return {
      deep: await draw(30, 'auto'),
      deepEven: await draw(30, 0),
      flat: await draw(2, 'auto'),
      flatEven: await draw(2, 0),
    };
  });
  expect(ink.deepEven).toBeGreaterThan(500);
  expect(ink.deep).toBeLessThan(0.8 * ink.deepEven);
  expect(ink.flatEven).toBeGreaterThan(100);
  expect(ink.flat).toBe(ink.flatEven);
});
