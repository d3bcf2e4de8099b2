import type { Page } from '@playwright/test';
import type { HatchingMaterialOptions, StrokeStyleName } from 'three-hatching';
import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { difference } from './pixels.js';
import { test } from './toolkitPage.js';

/** Strokes keep the width they are drawn with, near and far (paper, sections 3.1 and 3.4). */

type Way = Partial<
  Pick<
    HatchingMaterialOptions,
    'technique' | 'perTriangle' | 'screenSpaceShare' | 'edgePixels' | 'strokeAngle' | 'strokeWidth'
  >
>;

const SIDE = 256;
/** Pixels, as the style draws them on every level of the map. */
const DRAWN_WIDTH = 1.9;
const DISTANCES = [1, 2, 4, 8];

const ways: Record<string, Way> = {
  'adjacency, level by derivatives': { technique: 'adjacency', perTriangle: { levelRule: 'derivatives' } },
  'adjacency, level by depth': { technique: 'adjacency', perTriangle: { levelRule: 'depth' } },
  'crisp, level by derivatives': { technique: 'triangle', perTriangle: { sharpInk: true, levelRule: 'derivatives' } },
  'crisp, level by depth': { technique: 'triangle', perTriangle: { sharpInk: true, levelRule: 'depth' } },
  'anchored, sized on the object': { technique: 'hatching', screenSpaceShare: 0 },
  'anchored, sized on the screen': { technique: 'hatching', screenSpaceShare: 1 },
};

for (const [name, parameters] of Object.entries(ways)) {
  test(
    `strokes are as wide as drawn at distances of 1, 2, 4 and 8: ${name}`,
    quickIf(
      ['adjacency, level by derivatives', 'crisp, level by depth', 'anchored, sized on the screen'].includes(name),
    ),
    async ({ page }) => {
      const pictures = await drawWall(page, parameters, DISTANCES);
      const widths = pictures.map(medianStrokeWidth);
      test.info().annotations.push({ type: 'width', description: widths.map((width) => width.toFixed(2)).join(', ') });
      for (const width of widths) {
        // Strokes of thresholds swell with the tone: the first is the drawn width for the others.
        const drawn = parameters.perTriangle?.sharpInk || parameters.technique === 'hatching' ? widths[0] : DRAWN_WIDTH;
        expect(width / drawn, widths.join()).toBeGreaterThan(0.75);
        expect(width / drawn, widths.join()).toBeLessThan(1.25);
      }
    },
  );
}

for (const style of ['hatching', 'ruled', 'dashes'] as const) {
  test(
    `strokeWidth is the width on the screen, however wide the style draws: ${style}`,
    quickIf(style === 'ruled'),
    async ({ page }) => {
      const parameters: Way = { technique: 'adjacency', perTriangle: { levelRule: 'depth' }, strokeWidth: 3 };
      const widths = (await drawWall(page, parameters, [2, 4], { style })).map(medianStrokeWidth);
      test.info().annotations.push({ type: 'width', description: widths.map((width) => width.toFixed(2)).join(', ') });
      for (const width of widths) {
        expect(width, widths.join()).toBeGreaterThan(0.8 * 3);
        expect(width, widths.join()).toBeLessThan(1.2 * 3);
      }
    },
  );
}

for (const crisp of [false, true]) {
  test(`face on, both rules choose the same level${crisp ? ', crisp' : ''}`, quickIf(!crisp), async ({ page }) => {
    const [derivatives, depth] = await Promise.all(
      (['derivatives', 'depth'] as const).map((levelRule) =>
        drawWall(page, { perTriangle: { sharpInk: crisp, levelRule } }, DISTANCES),
      ),
    );
    derivatives.forEach((picture, i) => {
      expect(difference(picture, depth[i]), `distance ${DISTANCES[i]}`).toBeLessThanOrEqual(12);
    });
  });
}

test('seen at a slant, depth chooses a finer level than derivatives, and so does anisotropy', async ({ page }) => {
  const [derivatives, depth, anisotropic] = [
    await drawWall(page, { perTriangle: { levelRule: 'derivatives' } }, [4], { slant: 1.3 }),
    await drawWall(page, { perTriangle: { levelRule: 'depth' } }, [4], { slant: 1.3 }),
    await drawWall(page, { perTriangle: { levelRule: 'derivatives' } }, [4], { slant: 1.3, anisotropy: 8 }),
  ].map(([picture]) => medianStrokeWidth(picture));
  expect(depth! / derivatives).toBeLessThan(0.75);
  expect(anisotropic! / derivatives).toBeLessThan(0.75);
});

for (const screenSpaceShare of [0, 1]) {
  test(
    `anchored strokes stay strokes at a slant, of the same tone: screenSpaceShare ${screenSpaceShare}`,
    quickIf(screenSpaceShare === 0),
    async ({ page }) => {
      const way: Way = { technique: 'hatching', screenSpaceShare, ...upright };
      const [faceOn, slanted] = [await drawWall(page, way, [1]), await drawWall(page, way, [1], { slant: 1.47 })].map(
        ([picture]) => spread(picture),
      );
      expect(faceOn.deviation).toBeGreaterThan(0.3);
      expect(slanted.deviation).toBeGreaterThan(0.3);
      // N·L, as the wall is lit; a few strokes more or less are seen.
      expect(Math.abs(slanted.mean - 5 / 7)).toBeLessThan(0.06);
    },
  );
}

test('where strokes crowd at a slant their tone is shown, not some of them: crisp, level by depth', async ({
  page,
}) => {
  const way: Way = { technique: 'triangle', perTriangle: { sharpInk: true, levelRule: 'depth' }, ...upright };
  const [hard, soft] = [
    await drawWall(page, { ...way, edgePixels: 0 }, [4], { slant: 1.47 }),
    await drawWall(page, way, [4], { slant: 1.47 }),
  ].map(([picture]) => spread(picture));
  expect(hard.deviation).toBeGreaterThan(0.3);
  expect(soft.deviation).toBeLessThan(0.15);
  expect(Math.abs(soft.mean - 5 / 7)).toBeLessThan(0.02);
});

/** Strokes that stand upright on the wall. */
const upright = { strokeAngle: Math.PI / 2 } satisfies Way;

/** The mean of red in [0, 1] in the middle of the picture, which a wall covers at any slant. */
function spread(red: number[]): { mean: number; deviation: number } {
  const values = red.filter((_, i) => Math.abs((i % SIDE) - SIDE / 2) < 16).map((value) => value / 255);
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  return { mean, deviation: Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length) };
}

/**
 * Red of a wall of level strokes at each distance, bottom row first. At a distance of 1 a texel is a pixel. `slant` turns
 * the wall about the upright axis.
 */
async function drawWall(
  page: Page,
  parameters: Way,
  distances: readonly number[],
  { slant = 0, anisotropy = 1, style = 'hatching' as StrokeStyleName } = {},
): Promise<number[][]> {
  return page.evaluate(
    async ([parameters, distances, slant, anisotropy, style, side]) => {
      const { THREE, TonalArtMap, hatchedMesh, makeRenderer, sceneOf, sun } = window.toolkit;
      const tonalArtMap = await TonalArtMap.generate({ style, size: 256 });
      tonalArtMap.texture.anisotropy = anisotropy;
      const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50);
      const unitsPerPixel = (2 * Math.tan(Math.PI / 9)) / side;
      const mesh = await hatchedMesh(new THREE.PlaneGeometry(40, 8), {
        ...parameters,
        tonalArtMap,
        tilesPerObjectUnit: 1 / (256 * unitsPerPixel),
      });
      mesh.rotation.y = slant;
      // N·L = 5/7: exactly the third of eight hatch images. Turned with the wall.
      const light = sun(Math.PI, [0, Math.sqrt(24) / 5, 1]);
      light.position.applyAxisAngle(new THREE.Vector3(0, 1, 0), slant);
      const scene = sceneOf(mesh, light);
      const renderer = makeRenderer();
      renderer.setSize(side, side, false);
      return distances.map((distance) => {
        camera.position.z = distance;
        renderer.render(scene, camera);
        const gl = renderer.getContext();
        const pixels = new Uint8Array(side * side * 4);
        gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return Array.from({ length: side * side }, (_, i) => pixels[4 * i]);
      });
    },
    [parameters, distances, slant, anisotropy, style, SIDE] as const,
  );
}

/** The ink of a stroke across it, in pixels: the median over all upright lines of pixels. */
function medianStrokeWidth(red: number[]): number {
  const widths: number[] = [];
  for (let x = 0; x < SIDE; x++) {
    let [ink, darkest] = [0, 0];
    for (let y = 0; y < SIDE; y++) {
      const darkness = 1 - red[y * SIDE + x] / 255;
      if (darkness > 0.05) {
        ink += darkness;
        darkest = Math.max(darkest, darkness);
      } else {
        // Isolated grey is the end of a stroke, or a stroke that only another tone has.
        if (darkest > 0.6) widths.push(ink);
        [ink, darkest] = [0, 0];
      }
    }
  }
  expect(widths.length, 'strokes measured').toBeGreaterThan(300);
  return widths.sort((a, b) => a - b)[widths.length >> 1];
}
