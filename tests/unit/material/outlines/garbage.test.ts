import {
  BoxGeometry,
  IcosahedronGeometry,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { leastPerFrame } from '../../allocated.js';

/** The number of frames after which V8 has compiled the code: before that, every computed number is allocated. */
const WARM_UP_FRAMES = 4000;
const FRAMES = 1000;
const MESHES = 50;
/** Numbers that a material copies from a surface are allocated: few meshes have any. */
const FEW = 5;
/** The number of bytes that a frame may leave. A number per mesh takes 12. */
const MOST = 400;
/** The same for meshes whose groups look different: two numbers for each of their 30 groups and some. A list of parts for each mesh takes 36,000. */
const MOST_OF_GROUPS = 1000;

const target = new Vector4(0, 0, 100, 100);
const kept = { uniformsList: [{ id: 'ink' }, { id: 'eye' }] };
const renderer = {
  info: { render: { frame: 0 } },
  properties: { get: () => kept },
  // The depth of a WebXR framebuffer cannot be copied.
  xr: { isPresenting: true },
  getPixelRatio: () => 2,
  getCurrentViewport: (viewport: Vector4) => viewport.copy(target),
  renderBufferDirect: () => {},
} as unknown as WebGLRenderer;

/** Draws outlines of meshes frame by frame until the code is compiled, and then measures the garbage. */
function expectNoGarbage(
  make: (i: number, material: HatchingOutlineMaterial) => Mesh,
  meshes: number,
  most: number,
): void {
  const scene = new Scene();
  const camera = new PerspectiveCamera(120);
  camera.position.z = 40;
  const material = new HatchingOutlineMaterial();
  const drawn = Array.from({ length: meshes }, (_, i) => {
    const mesh = make(i, material);
    mesh.applyMatrix4(new Matrix4().makeTranslation(0.1 * i, 0.5, 0.25));
    const outlines = new HatchingOutlines(mesh, material);
    scene.add(mesh.add(outlines));
    return outlines;
  });
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  const drawFrames = (count: number): void => {
    for (let i = 0; i < count; i++) {
      renderer.info.render.frame++;
      for (const outlines of drawn) {
        outlines.onBeforeRender(renderer, scene, camera);
        if (material.uniformsNeedUpdate) material.uniformsNeedUpdate = false;
        outlines.onAfterRender(renderer, scene, camera);
      }
    }
  };
  drawFrames(WARM_UP_FRAMES);
  const drawnVertices = drawn.map((one) => one.geometry.drawRange.count);
  expect(Math.min(...drawnVertices)).toBeGreaterThan(0);
  const { sum, places } = leastPerFrame(drawFrames, FRAMES, most);
  expect(sum, places).toBeLessThan(most);
}

test('frames of outlines leave no garbage', async () => {
  const geometry = await prepareHatchingGeometry(new IcosahedronGeometry(0.4), { layout: 'indexed', outlines: true });
  geometry.computeBoundingSphere();
  expectNoGarbage(() => new Mesh(geometry, new MeshBasicMaterial()), MESHES, MOST);
});

test('frames of meshes with different groups leave no garbage', async () => {
  const geometry = await prepareHatchingGeometry(new BoxGeometry(), { layout: 'indexed', outlines: true });
  geometry.computeBoundingSphere();
  const looks = [{}, { transparent: true, opacity: 0.5 }, { depthTest: false }, { visible: false }];
  const materials = Array.from({ length: 6 }, (_, i) => new MeshBasicMaterial(looks[i % looks.length]));
  expectNoGarbage(() => new Mesh(geometry, materials) as unknown as Mesh, FEW, MOST_OF_GROUPS);
});
