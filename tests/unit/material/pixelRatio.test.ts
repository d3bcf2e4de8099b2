import { BoxGeometry, type Group, Mesh, PerspectiveCamera, Scene, type Vector4, type WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { scaledSizes } from '../../../src/look/measuredFacts.js';
import type { HatchingMaterialParameters } from '../../../src/material/checkValues.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';

const rendererOf = (pixelRatio: number): WebGLRenderer =>
  ({
    info: { render: { frame: 1 } },
    capabilities: { maxTextureSize: 4096 },
    getPixelRatio: () => pixelRatio,
    getRenderTarget: () => null,
    getCurrentViewport: (target: Vector4) => target.set(0, 0, 100, 100),
  }) as unknown as WebGLRenderer;

const mesh = new Mesh(new BoxGeometry());
const camera = new PerspectiveCamera();

/** The numeric uniforms, as a renderer draws with them. */
function numbersOf(material: HatchingMaterial, renderer: WebGLRenderer): [name: string, value: number][] {
  material.onBeforeRender(renderer, new Scene(), camera, mesh.geometry, mesh, undefined as unknown as Group);
  return Object.entries(material.uniforms).flatMap(([name, { value }]) =>
    typeof value === 'number' ? [[name, value]] : [],
  );
}

const SIZES = {
  paperGrainSize: 3,
  lineSpacing: 6,
  minLineSpacing: 5,
  strokeWidth: 2.5,
  strokeLength: 50,
  edgePixels: 1.5,
};

test.each(
  [0.5, 1, 2].flatMap((pixelRatio) => [0, 0.5, 1].map((screenSpaceShare) => [pixelRatio, screenSpaceShare] as const)),
)('sizes are in CSS pixels: at a pixel ratio of %d, sized on the screen by %d', (pixelRatio, screenSpaceShare) => {
  for (const technique of ['adjacency', 'hatching', 'engraving'] as const) {
    const look: HatchingMaterialParameters = { technique, screenSpaceShare, ...SIZES };
    const scaled = new HatchingMaterial({ ...look, ...scaledSizes(look, pixelRatio) });
    const material = new HatchingMaterial(look);
    expect(numbersOf(material, rendererOf(pixelRatio))).toEqual(numbersOf(scaled, rendererOf(1)));
    expect(material.strokeWidth).toBe(SIZES.strokeWidth);
  }
});

test('the edges of strokes are equally soft at any pixel ratio, and lines may be two pixels of the drawing buffer apart', () => {
  const material = new HatchingMaterial({ technique: 'engraving', minLineSpacing: 3 });
  const uniforms = [0.5, 1, 2].map((pixelRatio) => Object.fromEntries(numbersOf(material, rendererOf(pixelRatio))));
  expect(uniforms.map(({ edgePixels }) => edgePixels)).toEqual([1, 1, 1]);
  expect(uniforms.map(({ minLineSpacing }) => minLineSpacing)).toEqual([2, 3, 6]);
});

test('two renderers of different pixel ratios share a material, also in frames of the same number', () => {
  const material = new HatchingMaterial({ technique: 'hatching', strokeWidth: 2 });
  const [screen, dense] = [rendererOf(1), rendererOf(3)];
  const sizes = [screen, dense, screen].map((renderer) => Object.fromEntries(numbersOf(material, renderer)).dotPixels);
  expect(sizes).toEqual([2, 6, 2]);
});
