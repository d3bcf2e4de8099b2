import { expect } from '../browser/test.js';
import { at, centre } from './pixels.js';
import { techniques } from './techniques.js';
import { test } from './toolkitPage.js';

/** The surface's own colour as tone and as a tint: a checkerboard map under one light, against CIE lightness worked out by hand. */

const LIGHT = 0.8;
// A grey of 18.42 % looks half as light as white (L* is 50), and one of 1 % nearly black (L* is 8.99).
const SQUARES = { white: 1, middle: 0.18418651851, dark: 0.01 };
const LIGHTNESS = { white: 1, middle: 0.5, dark: 0.0899 };

/** The middles of two neighbouring squares. */
const places = [
  [36, 48],
  [60, 48],
] as const;

for (const technique of techniques) {
  test(`a checkerboard is as dark as its squares look, as far as local tone counts: ${technique}`, async ({ page }) => {
    const pictures = await page.evaluate(
      async ([technique, squares, light]) => {
        const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
        const renderer = makeRenderer();
        const board = (dark: number): InstanceType<typeof THREE.DataTexture> => {
          const map = new THREE.DataTexture(
            new Float32Array([dark, dark, dark, 1, 1, 1, 1, 1]),
            2,
            1,
            THREE.RGBAFormat,
            THREE.FloatType,
          );
          map.needsUpdate = true;
          return map;
        };
        const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), {
          technique,
          debugView: 'tone',
          map: board(1),
        });
        const scene = sceneOf(mesh, sun(light * Math.PI, [0, 0, 1]));
        const shown = [];
        for (const dark of [squares.middle, squares.dark]) {
          for (const colorHatching of [0, 0.7, 1]) {
            Object.assign(mesh.material, { colorHatching, map: board(dark) });
            shown.push(pixelsOf(scene, renderer));
          }
        }
        return shown;
      },
      [technique, SQUARES, LIGHT] as const,
    );
    const seen = pictures.map((pixels) => places.map(([x, y]) => at(pixels, x, y)[0] / 255));
    const expected = [LIGHTNESS.middle, LIGHTNESS.dark].flatMap((dark) =>
      [0, 0.7, 1].map((share) => [LIGHT * (1 - share * (1 - dark)), LIGHT]),
    );
    for (const [i, pair] of seen.entries()) {
      for (const [j, bright] of pair.entries()) expect(bright, `${i}, ${j}`).toBeCloseTo(expected[i][j], 2);
    }
  });
}

test('colours of the material, its map and its vertices multiply, and emitted light counts against them', async ({
  page,
}) => {
  const shown = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const geometry = new THREE.PlaneGeometry(2, 2);
    geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(12).fill(0.8), 3));
    const map = new THREE.DataTexture(new Uint8Array([128, 128, 128, 255]), 1, 1);
    map.needsUpdate = true;
    const color = new THREE.Color(0.5, 0.5, 0.5);
    const emissive = new THREE.Color(0.1, 0.1, 0.1);
    const parameters = { colorHatching: 1, debugView: 'tone', vertexColors: true, map, color, emissive } as const;
    return pixelsOf(sceneOf(await hatchedMesh(geometry, parameters), sun(Math.PI / 2, [0, 0, 1])));
  });
  const luminance = 0.8 * 0.5 * (128 / 255);
  const lightness = 1.16 * Math.cbrt(luminance) - 0.16;
  // Emitted light lightens the tone, and hides as much of the darkness of the colour.
  expect(centre(shown)[0] / 255).toBeCloseTo(0.6 * (1 - 0.9 * (1 - lightness)), 2);
});

test('without a fill there is ink and paper alone; half a fill is half a tint', async ({ page }) => {
  const [ink, tint, full] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const color = new THREE.Color(0.2, 0.6, 0.4);
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), { color, paper: new THREE.Color(1, 0.9, 0.8) });
    const scene = sceneOf(mesh, sun(Math.PI, [0, 0, 1]));
    return [0, 0.5, 1].map((colorFill) => {
      Object.assign(mesh.material, { colorFill });
      return pixelsOf(scene, renderer);
    });
  });
  const printed = (pixels: number[]) => centre(pixels).map((byte) => byte / 255);
  const expected = [
    [1, 0.9, 0.8],
    [0.6, 0.9 * 0.8, 0.8 * 0.7],
    [0.2, 0.9 * 0.6, 0.8 * 0.4],
  ];
  for (const [i, pixels] of [ink, tint, full].entries()) {
    for (const [c, value] of printed(pixels).entries()) expect(value).toBeCloseTo(expected[i][c], 2);
  }
});

test('a plan of values leaves out details of a map that are finer than strokes, and keeps coarser ones', async ({
  page,
}) => {
  const [fine, coarse, measured] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, pixelsOf } = window.toolkit;
    /** Stripes of black and white, each so many texels of 96 wide. */
    const stripes = (width: number): InstanceType<typeof THREE.DataTexture> => {
      const data = new Uint8Array(4 * 96 * 96);
      for (let i = 0; i < 96 * 96; i++) {
        const grey = Math.floor((i % 96) / width) % 2 ? 255 : 0;
        data.set([grey, grey, grey, 255], 4 * i);
      }
      const map = new THREE.DataTexture(data, 96, 96);
      map.minFilter = THREE.LinearMipmapLinearFilter;
      map.generateMipmaps = true;
      map.needsUpdate = true;
      return map;
    };
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), {
      ...{ technique: 'engraving', debugView: 'tone', colorHatching: 1, lineSpacing: 4, screenSpaceShare: 1 },
      ...{ composition: { exposure: 'fit' }, map: stripes(3) },
    });
    const scene = sceneOf(mesh, new THREE.AmbientLight(0xffffff, Math.PI));
    const row = (): number[] => {
      const pixels = pixelsOf(scene);
      return Array.from({ length: 96 }, (_, x) => pixels[4 * (48 * 96 + x)]);
    };
    const shown = [row()];
    mesh.material.map = stripes(24);
    mesh.material.composition.refit();
    shown.push(row());
    mesh.material.map = stripes(3);
    mesh.material.composition.plannedValues = 0;
    shown.push(row());
    return shown;
  });
  const spread = (row: readonly number[]): number => Math.max(...row.slice(30, 66)) - Math.min(...row.slice(30, 66));
  expect(spread(fine)).toBeLessThan(20);
  expect(spread(coarse)).toBeGreaterThan(40);
  expect(spread(measured)).toBeGreaterThan(100);
});
