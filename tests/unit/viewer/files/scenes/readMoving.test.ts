import { PNG } from 'pngjs';
import {
  AnimationClip,
  AnimationMixer,
  Bone,
  CylinderGeometry,
  Float32BufferAttribute,
  Group,
  LoopOnce,
  MeshPhongMaterial,
  NumberKeyframeTrack,
  type Object3D,
  QuaternionKeyframeTrack,
  Skeleton,
  SkinnedMesh,
  Vector3,
} from 'three';
import { ColladaLoader } from 'three/addons/loaders/ColladaLoader.js';
import { describe, expect, test, vi } from 'vitest';
import { buildModel } from '../../../../../src/viewer/drawing/buildModel.js';
import { meshesOf } from '../../../../../src/viewer/drawing/meshes.js';
import { type GltfParts, parseGltf } from '../../../../../src/viewer/files/gltf/parseGltf.js';
import { type ReadMesh, type ReadParts, readModel } from '../../../../../src/viewer/files/readModel.js';
import { readMoving } from '../../../../../src/viewer/files/scenes/readMoving.js';
import { BOX_CORNERS } from '../../../../../tools/modelFiles/box.js';
import { dae, fbx } from '../../../../../tools/modelFiles/sceneWriters.js';

const read = (text: string, others: [string, Uint8Array][] = []) =>
  readModel(
    [
      { name: 'box.dae', content: new Blob([text]) },
      ...others.map(([name, bytes]) => ({ name, content: new Blob([bytes as Uint8Array<ArrayBuffer>]) })),
    ],
    () => {},
  );

describe("a model of three's other loaders that moves", () => {
  test('is drawn in motion, with its colours', async () => {
    const message = vi.spyOn(console, 'warn');
    const model = await read(dae(undefined, true));
    expect(model.notes).toEqual([]);
    expect(model.kind).toBe('parts');
    const { model: drawn } = await buildModel(model, () => {}, new AbortController().signal);
    const { motion, statistics, bounds } = drawn;
    expect(statistics.triangles).toBe(12);
    expect(motion!.clips.length).toBe(1);
    expect(motion!.duration).toBe(1);
    // It goes from one side to the other.
    expect(bounds.max.x - bounds.min.x).toBeGreaterThan(1.5 * (bounds.max.z - bounds.min.z));
    expect(message).not.toHaveBeenCalled();
  });

  test('is drawn at rest where its vertices lie so far from its origin that glTF would round them', async () => {
    const corners = BOX_CORNERS.map((corner) => corner.join(' ')).join(' ');
    const far = BOX_CORNERS.map(([x, y, z]) => [0.25 * x + 1e7, 0.25 * y, 0.25 * z].join(' ')).join(' ');
    const model = await read(dae(undefined, true).replaceAll(corners, far));
    expect([model.kind, model.notes]).toEqual(['mesh', ['shown without its motion']]);
    const side = 1 / Math.sqrt(3);
    for (const value of (model as ReadMesh).mesh.positions) expect(Math.abs(value)).toBeCloseTo(side, 5);
    const message = vi.spyOn(console, 'error');
    await read(dae(undefined, true).replaceAll(corners, corners.replace('1', 'x')));
    expect(message).not.toHaveBeenCalled();
  });

  test('has its pictures, the right way up, or names those that are missing', async () => {
    const picture = PNG.sync.write(new PNG({ width: 8, height: 4 }));
    const model = (await read(dae('textures/my wood.png', true), [['my wood.png', picture]])) as ReadParts;
    expect(model.notes).toEqual([]);
    expect(model.parts.pictures[0]).toMatchObject({ width: 8, height: 4 });
    const { materials } = model.parts.json as { materials: { pbrMetallicRoughness: object }[] };
    expect(JSON.stringify(materials)).toContain('"KHR_texture_transform":{"offset":[0,1],"scale":[1,-1]}');
    const lacking = await read(dae('textures/my wood.png', true));
    expect([lacking.missing, lacking.notes]).toEqual([['my wood.png'], ['my wood.png is missing: drop it along']]);
  });

  test('stands still, and the caption says so, where its motion is damaged', async () => {
    for (const [from, to] of [
      ['>0 1</float_array>', '>0 nan</float_array>'],
      ['node/transform', 'nobody/transform'],
    ]) {
      const parsing = vi.spyOn(ColladaLoader.prototype, 'parse');
      const model = await read(dae(undefined, true).replace(from, to));
      expect([model.kind, model.notes]).toEqual(['mesh', ['shown without its motion']]);
      expect(parsing).toHaveBeenCalledTimes(1);
      parsing.mockRestore();
    }
  });

  test('also where an FBX file moves it', async () => {
    const content = new Blob([fbx(7300, true)]);
    const model = await readModel([{ name: 'box.fbx', content }], () => {});
    expect([model.kind, model.notes]).toEqual(['parts', []]);
    const { root, animations } = await parseGltf((model as ReadParts).parts);
    const xs = placesAt(root, animations, [0, 1]).map((places) => Math.max(...places.map(([x]) => x)));
    expect(xs[1] - xs[0]).toBeCloseTo(4, 5);
  });

  test('keeps the poses of bones and morph targets, and drops tracks without a visible target', async () => {
    const { root, clip } = tube();
    const expected = placesAt(root, [clip], [0, 0.4, 1]);
    // Of a camera that is not there.
    clip.tracks.push(new NumberKeyframeTrack('eye.fov', [0, 1], [30, 60]));
    root.animations = [clip];
    const moving = (await readMoving(root, 'tube.fbx', async () => undefined)).moving!;
    expect(moving.notes).toEqual(['1 damaged animation track left out']);
    const parts = moving.content as GltfParts;
    // As a worker posts them.
    const scene = await parseGltf(structuredClone(parts, { transfer: parts.arrays }));
    const shown = placesAt(scene.root, scene.animations, [0, 0.4, 1]);
    for (const [t, places] of shown.entries()) {
      expect(places.length).toBe(expected[t].length);
      for (const [i, place] of places.entries()) {
        for (const axis of [0, 1, 2]) expect(place[axis]).toBeCloseTo(expected[t][i][axis], 4);
      }
    }
    const moved = expected[2].map((place, i) =>
      Math.hypot(...place.map((value, axis) => value - expected[0][i][axis])),
    );
    expect(Math.max(...moved)).toBeGreaterThan(1);
  });
});

test('a track names a morph target by its number, too, and one that does not move keeps its influence', async () => {
  const { root, clip } = tube();
  const [mesh] = meshesOf(root);
  const { position } = mesh.geometry.morphAttributes;
  const second = position![0].clone();
  second.name = 'lean';
  position!.push(second);
  mesh.morphTargetDictionary = { bulge: 0, lean: 1 };
  mesh.morphTargetInfluences = [0, 0.25];
  clip.tracks = [new NumberKeyframeTrack('tube.morphTargetInfluences[0]', [0, 1], [0, 0.8])];
  root.animations = [clip];
  const expected = placesAt(root, [clip], [0, 0.5]);
  const moving = (await readMoving(root, 'tube.fbx', async () => undefined)).moving!;
  expect(moving.notes).toEqual([]);
  const scene = await parseGltf(moving.content as GltfParts);
  const shown = placesAt(scene.root, scene.animations, [0, 0.5]).flat();
  for (const [i, place] of expected.flat().entries())
    for (const axis of [0, 1, 2]) expect(shown[i][axis]).toBeCloseTo(place[axis], 4);
});

/** A tube that bends and bulges, turned and away from the origin. */
function tube(): { root: Group; clip: AnimationClip } {
  const geometry = new CylinderGeometry(0.3, 0.3, 2, 8, 6);
  const { position } = geometry.attributes;
  const upper = Array.from({ length: position.count }, (_, i) => (position.getY(i) + 1) / 2);
  geometry.setAttribute(
    'skinIndex',
    new Float32BufferAttribute(
      upper.flatMap(() => [0, 1, 0, 0]),
      4,
    ),
  );
  geometry.setAttribute(
    'skinWeight',
    new Float32BufferAttribute(
      upper.flatMap((share) => [1 - share, share, 0, 0]),
      4,
    ),
  );
  const bulge = position.clone();
  bulge.name = 'bulge';
  for (let i = 0; i < bulge.count; i++) bulge.setXYZ(i, position.getX(i), 0, position.getZ(i));
  geometry.morphAttributes.position = [bulge];
  geometry.morphTargetsRelative = true;
  const mesh = new SkinnedMesh(geometry, new MeshPhongMaterial({ color: 'red' }));
  mesh.name = 'tube';
  mesh.morphTargetDictionary = { bulge: 0 };
  mesh.morphTargetInfluences = [0];
  const bones = [new Bone(), new Bone()];
  bones.forEach((bone, i) => {
    bone.name = `bone${i}`;
  });
  bones[0].position.y = -1;
  bones[1].position.y = 1;
  bones[0].add(bones[1]);
  const root = new Group().add(mesh, bones[0]);
  root.rotation.set(0.3, 0.5, 0);
  root.position.set(3, 1, -2);
  root.updateMatrixWorld(true);
  mesh.bind(new Skeleton(bones));
  const turned = [0, 0, Math.SQRT1_2, Math.SQRT1_2];
  const clip = new AnimationClip('bend', -1, [
    new QuaternionKeyframeTrack('bone1.quaternion', [0, 1], [0, 0, 0, 1, ...turned]),
    new NumberKeyframeTrack('tube.morphTargetInfluences[bulge]', [0, 1], [0, 0.8]),
  ]);
  return { root, clip };
}

/** Where all vertices are at some times of the first clip. */
function placesAt(root: Object3D, clips: readonly AnimationClip[], times: readonly number[]): number[][][] {
  const mixer = new AnimationMixer(root);
  const [clip] = clips;
  // A clip that ends begins again.
  mixer.clipAction(clip).play().clampWhenFinished = true;
  mixer.clipAction(clip).setLoop(LoopOnce, 1);
  return times.map((time) => {
    mixer.setTime(time);
    root.updateMatrixWorld(true);
    const places: number[][] = [];
    const place = new Vector3();
    for (const mesh of meshesOf(root)) {
      for (let i = 0; i < mesh.geometry.attributes.position.count; i++) {
        places.push(mesh.getVertexPosition(i, place).applyMatrix4(mesh.matrixWorld).toArray());
      }
    }
    return places;
  });
}
