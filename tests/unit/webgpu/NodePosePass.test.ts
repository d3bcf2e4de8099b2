import {
  Bone,
  BoxGeometry,
  Camera,
  FloatType,
  type Mesh,
  MeshBasicMaterial,
  type RenderTarget,
  Skeleton,
  SkinnedMesh,
} from 'three';
import type { WebGPURenderer } from 'three/webgpu';
import { beforeEach, expect, test } from 'vitest';
import { hasFloatTargets, nodeDeformations } from '../../../src/webgpu/outlines/NodePosePass.js';

const camera = new Camera();
const outputs = { isMRTNode: true };
const drawObject = (): void => {};

interface Drawing {
  target: RenderTarget;
  bones: number;
  count: number;
  outputs: unknown;
  drawObject: unknown;
}

/** A renderer for a pass, which records what it draws. */
function recorder() {
  const drawings: Drawing[] = [];
  const state: { target: unknown[]; outputs: unknown; drawObject: unknown } = {
    target: ['canvas', 2, 3],
    outputs,
    drawObject,
  };
  const renderer = {
    domElement: new EventTarget(),
    info: { render: { calls: 7 } },
    getRenderTarget: () => state.target[0],
    getActiveCubeFace: () => state.target[1],
    getActiveMipmapLevel: () => state.target[2],
    setRenderTarget: (...target: unknown[]) => Object.assign(state, { target }),
    getMRT: () => state.outputs,
    setMRT: (next: unknown) => Object.assign(state, { outputs: next }),
    getRenderObjectFunction: () => state.drawObject,
    setRenderObjectFunction: (next: unknown) => Object.assign(state, { drawObject: next }),
    render(points: SkinnedMesh) {
      renderer.info.render.calls++;
      drawings.push({
        target: state.target[0] as RenderTarget,
        bones: points.skeleton?.bones.length ?? 0,
        count: points.geometry.drawRange.count,
        outputs: state.outputs,
        drawObject: state.drawObject,
      });
      drawn.add(points);
    },
  } as unknown as WebGPURenderer;
  const drawn = new Set<SkinnedMesh>();
  return { renderer, drawings, drawn, state };
}

/** A box with a number of bones. */
function onBones(count: number): SkinnedMesh {
  const mesh = new SkinnedMesh(new BoxGeometry(), new MeshBasicMaterial());
  const bones = Array.from({ length: count }, () => new Bone());
  mesh.add(...bones);
  mesh.bind(new Skeleton(bones));
  mesh.skeleton.update();
  return mesh;
}

let made = recorder();
beforeEach(() => {
  made = recorder();
});

const pose = (mesh: Mesh) =>
  nodeDeformations.of(made.renderer, camera, mesh, mesh.geometry, null, mesh.material as MeshBasicMaterial);

test('a pose is drawn when it has changed, and then once', () => {
  const mesh = onBones(2);
  const { target } = pose(mesh);
  pose(mesh);
  expect(made.drawings.length).toBe(1);
  mesh.skeleton.bones[1].rotation.x = 1;
  mesh.updateMatrixWorld();
  mesh.skeleton.update();
  expect(pose(mesh).target).toBe(target);
  expect(made.drawings.length).toBe(2);
});

test('a pose is drawn into two textures of floats, all of it, and whatever the renderer draws otherwise', () => {
  const mesh = onBones(2);
  mesh.geometry.setDrawRange(3, 6);
  pose(mesh);
  const [{ target, bones, count, outputs, drawObject }] = made.drawings;
  expect(target.textures.map(({ type }) => type)).toEqual([FloatType, FloatType]);
  expect(target.width * target.height).toBeGreaterThanOrEqual(mesh.geometry.attributes.position.count);
  expect({ bones, count, outputs, drawObject }).toEqual({ bones: 2, count: Infinity, outputs: null, drawObject: null });
});

test('the renderer and the geometry are left as they were', () => {
  const mesh = onBones(2);
  mesh.geometry.setDrawRange(3, 6);
  pose(mesh);
  expect(made.state).toEqual({ target: ['canvas', 2, 3], outputs, drawObject });
  expect(mesh.geometry.drawRange).toEqual({ start: 3, count: 6 });
  expect(made.renderer.info.render.calls).toBe(7);
});

test('meshes of as many bones are drawn by one program, and stay collectable', () => {
  const first = onBones(2);
  for (const count of [2, 2, 3]) {
    const mesh = onBones(count);
    mesh.geometry = first.geometry;
    pose(mesh);
  }
  expect(made.drawings.map(({ bones }) => bones)).toEqual([2, 2, 3]);
  expect(made.drawn.size).toBe(2);
  for (const points of made.drawn) expect(points.skeleton).toBeUndefined();
});

test('textures go with the geometry', () => {
  const mesh = onBones(1);
  const deformation = pose(mesh);
  mesh.geometry.dispose();
  expect(deformation.isDisposed).toBe(true);
});

test('WebGL needs an extension to draw into floats, WebGPU does not', () => {
  const by = (backend: object): boolean => hasFloatTargets({ backend } as WebGPURenderer);
  expect(by({ extensions: new Set(['EXT_color_buffer_float']) })).toBe(true);
  expect(by({ extensions: new Set() })).toBe(false);
  expect(by({ isWebGPUBackend: true })).toBe(true);
});
