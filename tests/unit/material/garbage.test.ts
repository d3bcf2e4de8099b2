import { BoxGeometry, type Group, Matrix4, Mesh, PerspectiveCamera, Scene, Vector4, type WebGLRenderer } from 'three';
import { expect, test, vi } from 'vitest';
import { prepareHatchingGeometry } from '../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { leastPerFrame } from '../allocated.js';

/** The number of frames after which V8 has compiled the code: before that, every computed number is allocated. */
const WARM_UP_FRAMES = 4000;
const FRAMES = 2000;
const MESHES = 50;
/** The number of bytes that a frame may leave. A number per mesh takes 12, a closure 20 or more. */
const MOST = 400;

const kept = { uniformsList: [{ id: 'ink' }, { id: 'fieldOrigin' }] };
const target = new Vector4(0, 0, 100, 100);
const renderer = {
  info: { render: { frame: 0 } },
  capabilities: { maxTextureSize: 4096 },
  properties: { get: () => kept },
  getPixelRatio: () => 2,
  getRenderTarget: () => null,
  getCurrentViewport: (viewport: Vector4) => viewport.copy(target),
} as unknown as WebGLRenderer;

/** Draws frames as three.js does, as far as it calls the material. */
function drawFrames(material: HatchingMaterial, scene: Scene, camera: PerspectiveCamera, count: number): void {
  for (let i = 0; i < count; i++) {
    renderer.info.render.frame++;
    for (const mesh of scene.children as Mesh[]) {
      material.onBeforeRender(renderer, scene, camera, mesh.geometry, mesh, null as unknown as Group);
      if (material.uniformsNeedUpdate) material.uniformsNeedUpdate = false;
    }
  }
}

const LOOKS = {
  pen: { preset: 'pen', composition: { exposure: 1 } },
  'pen in the light of its scene': { preset: 'pen' },
  engraving: { preset: 'engraving', composition: { exposure: 1 } },
  pencil: { preset: 'pencil', composition: { exposure: 1 }, tonalArtMap: null },
  chalk: { preset: 'chalk', composition: { exposure: 1 }, tonalArtMap: null },
} as const;

test.each(Object.entries(LOOKS))('frames leave no garbage: %s', async (_, look) => {
  await HatchingMaterial.preload();
  const material = new HatchingMaterial(look);
  const scene = new Scene();
  const geometry = await prepareHatchingGeometry(new BoxGeometry(), { layout: 'indexed' });
  for (let i = 0; i < MESHES; i++) {
    const mesh = new Mesh(geometry, material);
    // A frame of lines that differs for every mesh.
    mesh.userData.hatchingField = new Matrix4().makeTranslation(0.1 * i, 0.5, 0.25).toArray();
    mesh.userData.hatching = { importance: i % 2 };
    // No whole numbers, because those are never allocated.
    mesh.position.set(0.3 * i, 0.7, 0.1);
    mesh.rotation.set(0.1 * i, 0.2, 0.3);
    scene.add(mesh);
  }
  scene.updateMatrixWorld();
  const camera = new PerspectiveCamera();
  drawFrames(material, scene, camera, WARM_UP_FRAMES);
  // Everything that is loaded beside a first frame has loaded now.
  await vi.dynamicImportSettled();
  drawFrames(material, scene, camera, WARM_UP_FRAMES);
  const { sum, places } = leastPerFrame((frames) => drawFrames(material, scene, camera, frames), FRAMES, MOST);
  expect(sum, places).toBeLessThan(MOST);
});
