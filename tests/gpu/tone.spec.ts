import type { StrokeStyleName } from '../../src/strokes/strokeStyleNames.js';
import { strokeStyles } from '../../src/strokes/strokeStyles.js';
import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

for (const style of Object.keys(strokeStyles) as StrokeStyleName[]) {
  test(
    `anchored strokes print the tone asked for, at any size: ${style}`,
    quickIf(style === 'hatching'),
    async ({ page }, testInfo) => {
      const errors = await page.evaluate(measureTones, style);
      testInfo.annotations.push({
        type: 'tone error',
        description: errors.map((error) => error.toFixed(3)).join(', '),
      });
      for (const error of errors) expect(Math.abs(error), errors.join()).toBeLessThan(0.03);
    },
  );
}

/** Mean ink less the tone asked for, over tones and sizes of strokes, on a wall much larger than the map. */
async function measureTones(style: StrokeStyleName): Promise<number[]> {
  const { THREE, TonalArtMap, hatchedMesh, makeRenderer, sceneOf, sun } = window.toolkit;
  const [size, side, places] = [128, 512, 2];
  const tonalArtMap = await TonalArtMap.generate({ style, size });
  const camera = new THREE.PerspectiveCamera(90, 1, 0.1, 10);
  const mesh = await hatchedMesh(new THREE.PlaneGeometry(40, 40), {
    technique: 'hatching',
    tonalArtMap,
    edgePixels: 0,
  });
  const light = sun();
  const scene = sceneOf(mesh, light);
  const renderer = makeRenderer();
  renderer.setSize(side, side, false);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(side * side * 4);
  const errors = [];
  for (const level of [0, 0.25, 0.5, 0.75]) {
    // The size at which the map is too fine by this share of a level.
    mesh.material.tilesPerObjectUnit = (2 ** level * side) / (2 * size);
    for (const tone of [0.15, 0.4, 0.7]) {
      light.position.set(Math.sqrt(1 - (1 - tone) ** 2), 0, 1 - tone);
      let paper = 0;
      for (let place = 0; place < places; place++) {
        camera.position.set(2.1 * place, 2.1 * place, 1);
        renderer.render(scene, camera);
        gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        for (let i = 0; i < pixels.length; i += 4) paper += pixels[i];
      }
      errors.push(1 - paper / (255 * side * side * places) - tone);
    }
  }
  return errors;
}

test('a highlight that is kept is blank up to its tone, sharply or softly, and nothing changes beyond', async ({
  page,
}) => {
  const rows = await page.evaluate(async () => {
    const { THREE, greyMap, hatchedMesh, makeRenderer, sceneOf, sun } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(4, 4), { technique: 'triangle', tonalArtMap: greyMap() });
    const light = sun();
    const scene = sceneOf(mesh, light);
    const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 10);
    camera.position.z = 2;
    const renderer = makeRenderer();
    const gl = renderer.getContext();
    const pixel = new Uint8Array(4);
    const printed = (tone: number): number => {
      light.position.set(Math.sqrt(1 - (1 - tone) ** 2), 0, 1 - tone);
      renderer.render(scene, camera);
      gl.readPixels(48, 48, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return 1 - pixel[0] / 255;
    };
    const tones = [0.1, 0.25, 0.35, 0.5, 0.7];
    const row = (highlightThreshold: number, highlightSoftness: number): number[] => {
      Object.assign(mesh.material, { highlightThreshold, highlightSoftness });
      return tones.map(printed);
    };
    return { all: row(0, 0), sharp: row(0.3, 0), soft: row(0.3, 0.5) };
  });
  const { all, sharp, soft } = rows;
  for (const [i, tone] of [0.1, 0.25, 0.35, 0.5, 0.7].entries()) expect(all[i]).toBeCloseTo(tone, 1);
  expect(sharp.slice(0, 2)).toEqual([0, 0]);
  expect(sharp.slice(2)).toEqual(all.slice(2));
  // From 0.15 to 0.45.
  expect(soft[0]).toBe(0);
  expect(soft[1]).toBeCloseTo((all[1] * (0.25 - 0.15)) / 0.3, 1);
  expect(soft[2]).toBeCloseTo((all[2] * (0.35 - 0.15)) / 0.3, 1);
  expect(soft[1]).toBeLessThan(soft[2]);
  expect(soft.slice(3)).toEqual(all.slice(3));
});
