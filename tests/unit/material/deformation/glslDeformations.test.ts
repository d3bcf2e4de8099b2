import {
  Bone,
  BoxGeometry,
  Camera,
  Float32BufferAttribute,
  Mesh,
  MeshBasicMaterial,
  Skeleton,
  SkinnedMesh,
  type WebGLRenderer,
} from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import type { Deformation } from '../../../../src/material/deformation/Deformation.js';
import { glslDeformations } from '../../../../src/material/deformation/PrePass.js';

const camera = new Camera();

/** The parts of a renderer that a pre-pass uses. Counts the draws. */
function countingRenderer() {
  const drawn = { passes: 0, targets: new Set<unknown>() };
  let target: unknown = null;
  const renderer = {
    properties: {},
    domElement: new EventTarget(),
    getRenderTarget: () => target,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
    setRenderTarget: (next: unknown) => {
      target = next;
    },
    renderBufferDirect: () => {
      drawn.passes++;
      drawn.targets.add(target);
    },
  } as unknown as WebGLRenderer;
  return { renderer, drawn };
}

function bulgingBox() {
  const geometry = new BoxGeometry();
  geometry.morphAttributes.position = [new Float32BufferAttribute(geometry.attributes.position.array.slice(), 3)];
  return geometry;
}

describe('meshes that share a geometry', () => {
  let crowd: Mesh[];
  let material: MeshBasicMaterial;
  let { renderer, drawn } = countingRenderer();
  const draw = (mesh: Mesh, with_ = material): Deformation =>
    glslDeformations.of(renderer, camera, mesh, mesh.geometry, null, with_);
  const drawAll = (): Set<Deformation> => new Set(crowd.map((mesh) => draw(mesh)));
  const pose = (influence: number): void => {
    for (const mesh of crowd) mesh.morphTargetInfluences![0] = influence;
  };

  beforeEach(() => {
    const geometry = bulgingBox();
    material = new MeshBasicMaterial();
    crowd = Array.from({ length: 50 }, () => new Mesh(geometry, material));
    ({ renderer, drawn } = countingRenderer());
  });

  test('and a pose share its textures, which are drawn once', () => {
    expect(drawAll().size).toBe(1);
    drawAll();
    expect(drawn.passes).toBe(1);
  });

  test('and move together alternate between two, with one pass per frame', () => {
    drawAll();
    for (let frame = 1; frame <= 10; frame++) {
      pose(frame / 10);
      expect(drawAll().size).toBe(1);
      expect(drawn.passes).toBe(1 + frame);
    }
    expect(drawn.targets.size).toBe(2);
  });

  test('each have their own pose, whatever the others do', () => {
    crowd.forEach((mesh, i) => {
      mesh.morphTargetInfluences![0] = (i % 5) / 5;
    });
    expect(drawAll().size).toBe(5);
    expect(drawn.passes).toBe(5);
    // One mesh leaves the shared pose, and returns to it.
    const [mover, other] = [crowd[0], crowd[5]];
    const shared = draw(other);
    expect(draw(mover)).toBe(shared);
    mover.morphTargetInfluences![0] = 0.55;
    const own = draw(mover);
    expect(own).not.toBe(shared);
    expect([draw(other), own.pose.isOf([0.55]), shared.pose.isOf([0])]).toEqual([shared, true, true]);
    mover.morphTargetInfluences![0] = 0;
    expect(draw(mover)).toBe(shared);
    expect(drawn.passes).toBe(6);
  });

  test('and move separately are drawn into their own textures', () => {
    for (let frame = 0; frame < 3; frame++) {
      crowd.forEach((mesh, i) => {
        mesh.morphTargetInfluences![0] = i / 100 + frame;
      });
      expect(drawAll().size).toBe(crowd.length);
      expect(drawn.passes).toBe((frame + 1) * crowd.length);
    }
    expect(drawn.targets.size).toBe(crowd.length);
  });

  test('build one program', () => {
    for (const mesh of crowd) glslDeformations.compile(renderer, mesh, mesh.geometry, null);
    expect(drawn.passes).toBe(1);
  });

  test('lose the deformations of a disposed material, and draw again with another', () => {
    const [first] = drawAll();
    const other = new MeshBasicMaterial();
    material.dispose();
    expect(first.isDisposed).toBe(true);
    const again = draw(crowd[0], other);
    expect([again.isDisposed, draw(crowd[1], other)]).toEqual([false, again]);
    expect(drawn.passes).toBe(2);
    crowd[0].geometry.dispose();
    expect(again.isDisposed).toBe(true);
  });

  test('and have skins have textures each of their own', () => {
    const skinned = [0, 1].map(() => {
      const mesh = new SkinnedMesh(crowd[0].geometry, material);
      const bone = new Bone();
      mesh.add(bone);
      mesh.bind(new Skeleton([bone]));
      mesh.skeleton.update();
      return mesh;
    });
    expect(new Set(skinned.map((mesh) => draw(mesh))).size).toBe(2);
  });
});
