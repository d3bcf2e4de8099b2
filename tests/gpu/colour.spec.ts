import { expect } from '../browser/test.js';
import { at, centre, covered, difference, isGround } from './pixels.js';
import { techniques } from './techniques.js';
import { test } from './toolkitPage.js';

/** Ink on paper: what covers, what multiplies, and what is seen through. three's own basic material says what a colour is. */

/** Darkness of the hatch at tone 1/2 of the grey map: image 2 of 4, in bytes. */
const HALF = 127 / 255;
const INK = [0.2, 0.4, 1];
const GROUND = [0.5 * 1, 1 * 0.8, 0.5 * 0.6];
const mix = (a: number[], b: number[], share: number) => a.map((x, i) => x * (1 - share) + b[i] * share);

const blends = {
  cover: mix(GROUND, INK, HALF),
  multiply: mix(
    GROUND,
    GROUND.map((x, i) => x * INK[i]),
    HALF,
  ),
};

for (const [inkBlend, color] of Object.entries(blends)) {
  test(`ink that is to ${inkBlend}: in linear light, under tone mapping, in sRGB and in fog`, async ({ page }) => {
    const pairs = await page.evaluate(
      async ([inkBlend, color]) => {
        const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
        const geometry = new THREE.PlaneGeometry(2, 2);
        const hatched = await hatchedMesh(geometry, {
          inkBlend,
          toneMapped: true,
          ink: new THREE.Color(0.2, 0.4, 1),
          paper: new THREE.Color(1, 0.8, 0.6),
          color: new THREE.Color(0.5, 1, 0.5),
        });
        const plain = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: new THREE.Color(...color) }));
        const renderer = makeRenderer();
        const scenes = [hatched, plain].map((mesh) => sceneOf(mesh, sun(Math.PI / 2, [0, 0, 1])));
        const both = () => scenes.map((scene) => pixelsOf(scene, renderer));
        const linear = both();
        renderer.toneMapping = THREE.ACESFilmicToneMapping;
        renderer.outputColorSpace = THREE.SRGBColorSpace;
        const mapped = both();
        for (const scene of scenes) scene.fog = new THREE.Fog(0x0000ff, 2, 6);
        return [linear, mapped, both()];
      },
      [inkBlend as 'cover' | 'multiply', color as [number, number, number]] as const,
    );
    for (const [hatched, plain] of pairs) {
      expect(covered(hatched)).toBeGreaterThan(2000);
      expect(difference(hatched, plain)).toBeLessThanOrEqual(1);
    }
    expect(difference(pairs[0][0], pairs[1][0])).toBeGreaterThan(20);
    expect(difference(pairs[1][0], pairs[2][0])).toBeGreaterThan(20);
  });
}

for (const premultipliedAlpha of [false, true]) {
  test(`see-through paper is blended once, ${premultipliedAlpha ? '' : 'not '}premultiplied`, async ({ page }) => {
    const paperOpacity = 0.25;
    const alpha = 1 - (1 - paperOpacity) * (1 - HALF);
    const premultiplied = mix(
      GROUND.map((x) => x * paperOpacity),
      INK,
      HALF,
    );
    const color = premultiplied.map((x) => x / alpha);
    const pairs = await page.evaluate(
      async ([premultipliedAlpha, paperOpacity, color, opacity]) => {
        const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
        const geometry = new THREE.PlaneGeometry(2, 2);
        const hatched = await hatchedMesh(geometry, {
          transparent: true,
          premultipliedAlpha,
          paperOpacity,
          toneMapped: true,
          ink: new THREE.Color(0.2, 0.4, 1),
          paper: new THREE.Color(1, 0.8, 0.6),
          color: new THREE.Color(0.5, 1, 0.5),
        });
        const plain = new THREE.Mesh(
          geometry,
          new THREE.MeshBasicMaterial({
            transparent: true,
            premultipliedAlpha,
            opacity,
            color: new THREE.Color(...color),
          }),
        );
        const renderer = makeRenderer({ alpha: true });
        const scenes = [hatched, plain].map((mesh) => sceneOf(mesh, sun(Math.PI / 2, [0, 0, 1])));
        const both = () => scenes.map((scene) => pixelsOf(scene, renderer));
        const overGreen = both();
        renderer.toneMapping = THREE.ReinhardToneMapping;
        renderer.outputColorSpace = THREE.SRGBColorSpace;
        const mapped = both();
        // The alpha that is left for what the page shows below the canvas.
        for (const scene of scenes) scene.background = null;
        renderer.setClearColor(0x000000, 0);
        return [overGreen, mapped, both()];
      },
      [premultipliedAlpha, paperOpacity, color as [number, number, number], alpha] as const,
    );
    for (const [hatched, plain] of pairs) expect(difference(hatched, plain)).toBeLessThanOrEqual(1);
    const [overGreen, , onNothing] = pairs.map(([hatched]) => hatched);
    const expected = mix(
      [0, 255, 0],
      color.map((x) => 255 * x),
      alpha,
    );
    centre(overGreen).forEach((value, i) => {
      expect(Math.abs(value - expected[i])).toBeLessThanOrEqual(1);
    });
    expect(onNothing[4 * (48 * 96 + 48) + 3]).toBeCloseTo(255 * alpha, -0.3);
  });
}

test('without paper, blank places show objects behind, and full ink covers them', async ({ page }) => {
  const [lit, dark, opaque] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const show = async (intensity: number, transparent: boolean) =>
      pixelsOf(
        sceneOf(
          await hatchedMesh(new THREE.PlaneGeometry(2, 2), { paperOpacity: 0, transparent, ink: 'navy' }),
          sun(intensity, [0, 0, 1]),
        ),
      );
    return [await show(Math.PI, true), await show(0, true), await show(Math.PI, false)];
  });
  expect(covered(lit)).toBe(0);
  expect(centre(dark)[1]).toBe(0);
  expect(centre(dark)[2]).toBeGreaterThan(0);
  expect(centre(opaque), 'drawn opaque, there is nothing to see through').toEqual([255, 255, 255]);
});

for (const technique of techniques) {
  test(`alphaTest cuts strokes out of their paper, and they hide what is behind them: ${technique}`, async ({
    page,
  }) => {
    const pixels = await page.evaluate(async (technique) => {
      const { THREE, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf } = window.toolkit;
      const strokes = await hatchedMesh(new THREE.PlaneGeometry(2, 2), {
        tonalArtMap: stripedMap(),
        technique,
        alphaTest: 0.5,
        paperOpacity: 0,
        ink: 'blue',
        ...(technique === 'engraving' ? { lineSpacing: 12, screenSpaceShare: 1 } : { edgePixels: 0 }),
      });
      strokes.renderOrder = 0;
      const behind = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), new THREE.MeshBasicMaterial({ color: 'red' }));
      behind.position.z = -0.1;
      // Drawn after the strokes: only their depth keeps it from covering them.
      behind.renderOrder = 1;
      return pixelsOf(sceneOf(strokes, behind, sun(Math.PI / 2, [0.3, 0.4, 1])));
    }, technique);
    const seen = { blue: 0, red: 0, ground: 0, other: 0 };
    for (let y = 30; y < 66; y++) {
      for (let x = 30; x < 66; x++) {
        const [r, g, b] = at(pixels, x, y);
        if (r === 0 && g === 0 && b === 255) seen.blue++;
        else if (r === 255 && g === 0 && b === 0) seen.red++;
        else if (isGround([r, g, b])) seen.ground++;
        else seen.other++;
      }
    }
    expect(seen.blue, 'strokes').toBeGreaterThan(200);
    expect(seen.red, 'what is behind, between the strokes').toBeGreaterThan(200);
    expect(seen.other).toBe(0);
  });
}

test('alphaHash leaves as many pixels as there is ink', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(4, 4), { alphaHash: true, paperOpacity: 0, ink: 'blue' });
    return pixelsOf(sceneOf(mesh, sun(Math.PI / 2, [0, 0, 1])));
  });
  expect(covered(pixels) / 96 ** 2).toBeCloseTo(0.5, 1);
  const inks = new Set<string>();
  for (let i = 0; i < pixels.length; i += 4) {
    const rgb = pixels.slice(i, i + 3);
    if (!isGround(rgb)) inks.add(rgb.join());
  }
  expect([...inks]).toEqual(['0,0,255']);
});
