import type { Scene, WebGLRenderer } from 'three';
import type { HatchingMaterialParameters, HatchingOutlineParameters } from 'three-hatching';
import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** Sizes in CSS pixels: a drawing of more or fewer pixels, brought to the same size, has the same strokes. */

/** The width and height of a drawing in CSS pixels. */
const SIDE = 160;

test.beforeEach(async ({ page }) => {
  await page.evaluate(async (side) => {
    const { THREE, makeRenderer, applyHatching, sun, sceneOf, TonalArtMap } = window.toolkit;
    const lit = [sun(0.35 * Math.PI, [-2, 3, 2]), new THREE.AmbientLight(0xffffff, 0.25 * Math.PI)];
    const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 20);
    camera.position.z = 4.5;
    const map = await TonalArtMap.generate({ size: 256 });

    /** The darkness of each pixel of what was drawn, the lowest row first. */
    const inkOf = (pixels: Uint8Array): number[] =>
      Array.from({ length: pixels.length / 4 }, (_, i) => 1 - pixels[4 * i] / 255);

    window.drawing = {
      /** A scene of paper and black, hatched with a look. */
      async sceneWith({ outlines, material }: Look) {
        const subject = outlines ? new THREE.IcosahedronGeometry(0.9, 1) : new THREE.PlaneGeometry(4, 4, 2, 2);
        const mesh = new THREE.Mesh(subject, new THREE.MeshLambertMaterial({ flatShading: true }));
        mesh.rotation.set(0.2, 0.3, 0);
        const scene = sceneOf(mesh, ...lit);
        scene.background = new THREE.Color(0xffffff);
        await applyHatching(mesh, { material, outlines: outlines ?? false, tonalArtMap: map });
        return scene;
      },
      rendererAt(pixelRatio: number) {
        const renderer = makeRenderer();
        renderer.setPixelRatio(pixelRatio);
        renderer.setSize(side, side, false);
        return renderer;
      },
      inCanvas(scene: Scene, renderer: WebGLRenderer): number[] {
        renderer.render(scene, camera);
        const gl = renderer.getContext();
        const { width, height } = renderer.domElement;
        const pixels = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return inkOf(pixels);
      },
      inTarget(scene: Scene, renderer: WebGLRenderer): number[] {
        const { width, height } = renderer.domElement;
        const target = new THREE.WebGLRenderTarget(width, height);
        renderer.setRenderTarget(target);
        renderer.render(scene, camera);
        const pixels = new Uint8Array(4 * width * height);
        renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
        renderer.setRenderTarget(null);
        return inkOf(pixels);
      },
    };
  }, SIDE);
});

/** The mean width of strokes along rows, in pixels: ink begins and ends at each. */
function widthOf(ink: number[]): number {
  const side = Math.sqrt(ink.length);
  let sum = 0;
  let change = 0;
  for (let i = 0; i < ink.length; i++) {
    sum += ink[i];
    if (i % side > 0) change += Math.abs(ink[i] - ink[i - 1]);
  }
  return (2 * sum) / change;
}

/** A picture with a pixel for every four. */
function scaledDown(ink: number[]): number[] {
  const side = Math.sqrt(ink.length);
  const small = side / 2;
  return Array.from({ length: small * small }, (_, i) => {
    const first = 2 * Math.floor(i / small) * side + 2 * (i % small);
    return (ink[first] + ink[first + 1] + ink[first + side] + ink[first + side + 1]) / 4;
  });
}

function correlation(a: number[], b: number[]): number {
  const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [meanA, meanB] = [mean(a), mean(b)];
  const product = (x: number[], mx: number, y: number[], my: number) =>
    x.reduce((sum, value, i) => sum + (value - mx) * (y[i] - my), 0);
  return product(a, meanA, b, meanB) / Math.sqrt(product(a, meanA, a, meanA) * product(b, meanB, b, meanB));
}

interface Look {
  material: HatchingMaterialParameters;
  outlines?: HatchingOutlineParameters;
}

declare global {
  interface Window {
    drawing: {
      sceneWith(look: Look): Promise<Scene>;
      rendererAt(pixelRatio: number): WebGLRenderer;
      inCanvas(scene: Scene, renderer: WebGLRenderer): number[];
      inTarget(scene: Scene, renderer: WebGLRenderer): number[];
    };
  }
}

const BLANK = [
  [0, 0],
  [1, 0],
] as const;

const LOOKS: Record<string, Look> = {
  strokes: { material: { technique: 'hatching', screenSpaceShare: 1, strokeWidth: 6 } },
  'strokes sized on the object': { material: { technique: 'hatching', tilesPerObjectUnit: 0.3, strokeWidth: 6 } },
  'crisp strokes of triangles': {
    material: { technique: 'adjacency', perTriangle: { sharpInk: true }, tilesPerObjectUnit: 0.3, strokeWidth: 6 },
  },
  'engraved lines': { material: { technique: 'engraving', screenSpaceShare: 1, lineSpacing: 12, irregularity: 0 } },
  'engraved lines sized half on the screen': {
    material: { technique: 'engraving', screenSpaceShare: 0.5, lineSpacing: 60, irregularity: 0 },
  },
  'strokes of a pen': {
    material: {
      technique: 'pen',
      screenSpaceShare: 1,
      lineSpacing: 12,
      strokeLength: 50,
      irregularity: 0,
    },
  },
  'wedges of a woodcut': {
    material: {
      technique: 'woodcut',
      screenSpaceShare: 1,
      lineSpacing: 12,
      strokeLength: 50,
      irregularity: 0,
    },
  },
  dots: { material: { technique: 'stipple', screenSpaceShare: 1, strokeWidth: 8 } },
  grain: { material: { technique: 'dryMedia', paperGrain: 1, paperGrainSize: 6, softness: 0.2 } },
  outlines: {
    material: { technique: 'hatching', toneCurve: BLANK },
    outlines: { outlineWidth: 5, wobble: 6, overshoot: 5, weights: { creases: 1, lit: 1, shade: 1 } },
  },
};

/** Grain has no strokes, and lines that are being born between others are thinner than a pixel. */
const WITHOUT_WIDTH = ['grain', 'engraved lines sized half on the screen'];

for (const [name, look] of Object.entries(LOOKS)) {
  test(
    `strokes stay where they are and as wide at another pixel ratio: ${name}`,
    quickIf(['strokes', 'engraved lines', 'dots'].includes(name)),
    async ({ page }) => {
      const [half, once, twice] = await page.evaluate(async (look) => {
        const { sceneWith, rendererAt, inCanvas } = window.drawing;
        const scene = await sceneWith(look as Look);
        return [0.5, 1, 2].map((ratio) => inCanvas(scene, rendererAt(ratio)));
      }, look as object);
      const [twiceScaled, onceScaled] = [twice, once].map(scaledDown);
      // Larger bumps of the paper have smaller ones on them.
      const least = name === 'grain' ? 0.9 : 0.98;
      expect(correlation(twiceScaled, once)).toBeGreaterThan(least);
      expect(correlation(onceScaled, half)).toBeGreaterThan(least);
      if (WITHOUT_WIDTH.includes(name)) return;
      const wider = widthOf(twiceScaled) / widthOf(once);
      expect(wider).toBeGreaterThan(0.97);
      expect(wider).toBeLessThan(1.03);
    },
  );
}

test('a render target and another renderer have the strokes of their own pixel ratio', { tag: '@all' }, async ({
  page,
}) => {
  const { alone, target, afterDense } = await page.evaluate(async (look) => {
    const { sceneWith, rendererAt, inCanvas, inTarget } = window.drawing;
    const scene = await sceneWith(look as Look);
    const [plain, dense] = [rendererAt(1), rendererAt(2)];
    const alone = inCanvas(scene, plain);
    const inDense = inCanvas(scene, dense);
    const target = inTarget(scene, dense).map((ink, i) => Math.abs(ink - inDense[i]));
    const afterDense = inCanvas(scene, plain);
    return { alone, target: Math.max(...target), afterDense };
  }, LOOKS.strokes as object);
  expect(target).toBeLessThan(0.01);
  expect(afterDense).toEqual(alone);
});
