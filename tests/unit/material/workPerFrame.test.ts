import { BoxGeometry, type Group, Mesh, PerspectiveCamera, Scene, type Vector4, type WebGLRenderer } from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';

const rendererAt = (frame: number): WebGLRenderer =>
  ({
    info: { render: { frame } },
    capabilities: { maxTextureSize: 4096 },
    getPixelRatio: () => 1,
    getRenderTarget: () => null,
    getCurrentViewport: (target: Vector4) => target.set(0, 0, 100, 100),
  }) as unknown as WebGLRenderer;

/** A material that counts reads of its map: by the code that writes it to the uniforms, or that looks for another program. */
function countingMaterial() {
  const material = new HatchingMaterial({ technique: 'hatching' });
  const count = { reads: 0 };
  Object.defineProperty(material, 'map', {
    get: () => {
      count.reads++;
      return null;
    },
  });
  return { material, count };
}

describe('the work of a frame', () => {
  const scene = new Scene();
  const camera = new PerspectiveCamera();
  const mesh = new Mesh(new BoxGeometry());
  const { material, count } = countingMaterial();
  const draw = (renderer: WebGLRenderer, from = camera): number => {
    const before = count.reads;
    material.onBeforeRender(renderer, scene, from, mesh.geometry, mesh, undefined as unknown as Group);
    return count.reads - before;
  };

  test('is done once for all the meshes of a material, for each camera, and again in the next frame', () => {
    const renderer = rendererAt(7);
    expect(draw(renderer)).toBeGreaterThan(0);
    expect(draw(renderer)).toBe(0);
    expect(draw(renderer, new PerspectiveCamera())).toBeGreaterThan(0);
    renderer.info.render.frame++;
    expect(draw(renderer)).toBeGreaterThan(0);
  });

  test('is done for another renderer in its frame of the same number', () => {
    expect(draw(rendererAt(8))).toBeGreaterThan(0);
  });

  test('is done for every mesh of a material that requests it', () => {
    const renderer = rendererAt(9);
    draw(renderer);
    material.strokeWidth = 3;
    material.uniformsNeedUpdate = true;
    expect(draw(renderer)).toBeGreaterThan(0);
    expect(material.uniforms.texelPixels.value).toBe(3);
  });
});

test('setting an unchanged choice does not change the program', async () => {
  const { material, count } = countingMaterial();
  await material.ready;
  material.strokeLayers = 'lights';
  const { reads } = count;
  expect(reads).toBeGreaterThan(0);
  material.strokeLayers = 'lights';
  expect(count.reads).toBe(reads);
  material.strokeLayers = 'single';
  expect(count.reads).toBeGreaterThan(reads);
});
