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
      material: { technique: 'engraving' },
      outlines: { outlineWidth: 2, weights: { lit: 1, shade: 1 } },
    });
    // In this light the sheets are blank.
    const scene = sceneOf(root, new THREE.AmbientLight('white', 2 * Math.PI));
    scene.background = new THREE.Color('white');
    const renderer = makeRenderer();
    const inks = [0, 0.5, 1].map((depthFade) => {
      hatched.composition.depthFade = depthFade;
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
    const widths = [0, air, 1].map((share) => 2 * (1 - fade * share) * (1 + 0.4 * fade * (1 - share)));
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
        material: { technique: 'engraving', toneCurve: 'linear', composition: { depthFade } },
      });
      const pixels = pixelsOf(sceneOf(root), renderer, new THREE.PerspectiveCamera(40, 1, 0.1, 100));
      hatched.dispose();
      // The unlit floor is black, before a green background.
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

test('objects of less importance are drawn lighter, outlines included, and those of importance 0 are blank paper that hides objects behind', {
  tag: '@all',
}, async ({ page }) => {
  const drawn = await page.evaluate(async () => {
    const { THREE, applyHatching, makeRenderer, pixelsOf, sceneOf, sun } = window.toolkit;
    // Two balls with one material, in groups of their own.
    const ball = new THREE.SphereGeometry(0.6, 64, 32);
    const paint = new THREE.MeshBasicMaterial();
    const groups = [-0.7, 0.7].map((x) => {
      const group = new THREE.Group().add(new THREE.Mesh(ball, paint));
      group.position.x = x;
      return group;
    });
    const root = new THREE.Group().add(...groups);
    await applyHatching(root, { material: { technique: 'engraving' }, outlines: true });
    const scene = sceneOf(root, sun());
    const renderer = makeRenderer();
    const draw = (...importances: unknown[]) => {
      for (const [i, group] of groups.entries()) group.userData.hatching = { importance: importances[i] };
      return pixelsOf(scene, renderer);
    };
    /** Black in the halves of a picture, and how many pixels of them are not the green ground. */
    const read = (pixels: number[]) => {
      const [ink, covered] = [
        [0, 0],
        [0, 0],
      ];
      for (let p = 0; p < pixels.length / 4; p++) {
        const half = p % 96 < 48 ? 0 : 1;
        const [red, green] = pixels.slice(4 * p, 4 * p + 2);
        ink[half] += (255 - green) / 255;
        covered[half] += Number(red > 0 || green < 255);
      }
      return { ink, covered };
    };
    const plain = draw(undefined, undefined);
    const least = { ...read(draw(1, 0)) };
    const half = read(draw(1, 0.5));
    return {
      same: draw(1, 1).every((value, i) => value === plain[i]),
      odd: draw('much', -1).every((value, i) => value === plain[i]),
      full: read(plain),
      half,
      least,
    };
  });
  expect(drawn.same).toBe(true);
  expect(drawn.odd).toBe(true);
  expect(drawn.full.ink[1]).toBeGreaterThan(100);
  expect(drawn.half.ink[0]).toBe(drawn.full.ink[0]);
  expect(drawn.half.ink[1]).toBeGreaterThan(0.3 * drawn.full.ink[1]);
  expect(drawn.half.ink[1]).toBeLessThan(0.7 * drawn.full.ink[1]);
  expect(drawn.least.ink[0]).toBe(drawn.full.ink[0]);
  expect(drawn.least.ink[1]).toBe(0);
  // The outlines stand out a little from the ball.
  expect(drawn.least.covered[1]).toBeGreaterThan(0.8 * drawn.full.covered[1]);
});

test('a vignette lies on the whole picture where it is drawn in tiles', async ({ page }) => {
  const { whole, tiled } = await page.evaluate(async () => {
    const { THREE, applyHatching, makeRenderer, pixelsOf, sceneOf, SIZE } = window.toolkit;
    const wall = new THREE.Mesh(new THREE.PlaneGeometry(9, 9), new THREE.MeshBasicMaterial());
    const root = new THREE.Group().add(wall);
    await applyHatching(root, {
      material: { technique: 'engraving', toneCurve: 'linear', composition: { vignette: 1 } },
    });
    const scene = sceneOf(root);
    const renderer = makeRenderer();
    const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50);
    camera.position.z = 4;
    const shades = (pixels: number[]) => pixels.filter((_, i) => i % 4 === 0);
    // Twice the size, and of that each quarter.
    const tiles = [0, 1, 2, 3].map((i) => {
      camera.setViewOffset(2 * SIZE, 2 * SIZE, (i % 2) * SIZE, Math.floor(i / 2) * SIZE, SIZE, SIZE);
      return shades(pixelsOf(scene, renderer, camera));
    });
    camera.clearViewOffset();
    const whole = shades(pixelsOf(scene, renderer, camera));
    const mean = (pixels: number[], x: number, y: number, size: number) => {
      let sum = 0;
      for (let j = y; j < y + size; j++) for (let i = x; i < x + size; i++) sum += pixels[j * SIZE + i];
      return sum / size ** 2;
    };
    const [inWhole, inTiles]: number[][] = [[], []];
    for (let y = 0; y < SIZE; y += 8) {
      for (let x = 0; x < SIZE; x += 8) {
        inWhole.push(mean(whole, x, y, 8));
        // Rows come from below, tiles from above.
        const tile = tiles[(y < SIZE / 2 ? 2 : 0) + (x < SIZE / 2 ? 0 : 1)];
        inTiles.push(mean(tile, (2 * x) % SIZE, (2 * y) % SIZE, 16));
      }
    }
    return { whole: inWhole, tiled: inTiles };
  });
  expect(Math.min(...whole)).toBeLessThan(40);
  expect(Math.max(...whole)).toBe(255);
  for (const [i, shade] of whole.entries()) expect(Math.abs(shade - tiled[i]), `place ${i}`).toBeLessThan(30);
});
