import { DoubleSide, FrontSide, type Material, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { addTrack, type GltfBuilder, tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';

const draw = async (name: string, content: BlobPart) =>
  buildModel(
    await readModel([{ name, content: new Blob([content]) }], () => {}),
    () => {},
    new AbortController().signal,
  );

test('a model whose triangles are all lines or points is refused, also one that moves', async () => {
  const sentence = 'There is nothing to draw: none of the triangles has an area.';
  const corners = 'v 0 0 0\nv 1 1 1\nv 2 2 2\nv 0 1 0\n';
  await expect(draw('line.obj', `${corners}f 1 2 3\nf 1 2 2\n`)).rejects.toThrow(sentence);
  expect((await draw('line.obj', `${corners}f 1 2 3\nf 1 2 4\n`)).model.statistics.degenerateTriangles).toBe(1);
  for (const share of [0, 1]) {
    const builder = tetrahedron();
    const flat = Uint16Array.of(0, 0, 1, 1, 2, share ? 3 : 2);
    builder.json.meshes[0].primitives[0].indices = builder.accessor(flat, 'SCALAR');
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 0), 'VEC3'));
    const drawn = draw('moves.glb', builder.glb() as Uint8Array<ArrayBuffer>);
    if (share) expect((await drawn).model.statistics.triangles).toBe(2);
    else await expect(drawn).rejects.toThrow(sentence);
  }
});

test('a glTF primitive without normals gets computed ones, with creases kept, as in other formats', async () => {
  const builder = tetrahedron();
  const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
  addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 0), 'VEC3'));
  const { model } = await draw('moves.glb', builder.glb() as Uint8Array<ArrayBuffer>);
  const [mesh] = meshesOf(model.root);
  expect(mesh.material).toMatchObject({ flatShading: false });
  expect(mesh.geometry.attributes.normal.count).toBeGreaterThan(3);
  model.dispose();
});

describe('the size of a model is that of its visible parts', () => {
  /** The tetrahedron beside one of nine times its size in another material, and whether it moves. */
  async function radiusOf(material: object, isMoving: boolean, colour?: readonly number[]): Promise<number> {
    const builder = tetrahedron();
    const { json } = builder;
    const part = structuredClone(json.meshes[0].primitives[0]);
    if (colour) part.attributes.COLOR_0 = builder.accessor(Float32Array.from(Array(4).fill(colour).flat()), 'VEC4');
    json.materials = [material];
    json.meshes.push({ primitives: [{ ...part, material: 0 }] });
    json.nodes.push({ mesh: 1, translation: [3, 0, 0], scale: [9, 9, 9] });
    json.scenes[0].nodes = [0, 1];
    if (isMoving) {
      const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
      addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 0, 0, 0), 'VEC3'));
    }
    return drawnRadius(builder);
  }

  /** The radius of which the page makes 1, in the units of the model. */
  async function drawnRadius(builder: GltfBuilder): Promise<number> {
    const { model } = await draw('model.glb', builder.glb() as Uint8Array<ArrayBuffer>);
    const [mesh] = meshesOf(model.root);
    mesh.updateWorldMatrix(true, false);
    const { position } = mesh.geometry.attributes;
    const [one, other] = [0, 1].map((i) =>
      new Vector3().fromBufferAttribute(position, i).applyMatrix4(mesh.matrixWorld),
    );
    model.dispose();
    return Math.sqrt(8) / one.distanceTo(other);
  }

  test('not with triangles of a part whose vertices are transparent', async () => {
    const builder = tetrahedron();
    const { json } = builder;
    const [part] = json.meshes[0].primitives;
    const corners = [1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1];
    const faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
    const alphas = [1, 0].flatMap((alpha) => Array(4).fill([1, 1, 1, alpha]).flat());
    part.attributes.POSITION = builder.accessor(
      Float32Array.from([...corners, ...corners.map((value) => 9 * value)]),
      'VEC3',
    );
    part.attributes.COLOR_0 = builder.accessor(Float32Array.from(alphas), 'VEC4');
    part.indices = builder.accessor(Uint16Array.from([...faces, ...faces.map((corner) => corner + 4)]), 'SCALAR');
    part.material = 0;
    json.materials = [{ alphaMode: 'BLEND' }];
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 0, 0, 0), 'VEC3'));
    expect(await drawnRadius(builder)).toBeCloseTo(Math.sqrt(3), 4);
  });

  const clear = { pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 0] } };
  for (const isMoving of [false, true]) {
    test.each([
      ['of alpha 0', { ...clear, alphaMode: 'BLEND' }, undefined],
      ['that its cutoff leaves out', { ...clear, alphaMode: 'MASK', alphaCutoff: 0.5 }, undefined],
      ['whose vertices are clear', { alphaMode: 'BLEND' }, [1, 1, 1, 0]],
    ] as const)(`not with a part %s, ${isMoving ? 'moving' : 'at rest'}`, async (_, material, colour) => {
      expect(await radiusOf(material, isMoving, colour)).toBeCloseTo(Math.sqrt(3), 4);
    });

    test(`with glass, ${isMoving ? 'moving' : 'at rest'}`, async () => {
      const pane = { alphaMode: 'BLEND', pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 0.25] } };
      expect(await radiusOf(pane, isMoving)).toBeGreaterThan(9);
    });
  }

  test.each([false, true])('wherever its nodes are; moving: %s', async (isMoving) => {
    const builder = tetrahedron();
    builder.json.nodes[0].translation = [1e7, -3e6, 5e6];
    if (isMoving) {
      const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
      addTrack(builder, 'rotation', times, builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1), 'VEC4'));
    }
    expect(await drawnRadius(builder)).toBeCloseTo(Math.sqrt(3), 4);
  });
});

describe('the sides of surfaces', () => {
  /** The sides of the materials of two tetrahedrons without a floor, one of them in a material that says `doubleSided`. */
  async function sidesOf(isMoving: boolean, hasBothSides = false): Promise<number[]> {
    const builder = tetrahedron();
    const { json } = builder;
    json.accessors[json.meshes[0].primitives[0].indices].count = 9;
    json.materials = [{ doubleSided: true }];
    json.meshes.push({ primitives: [{ ...json.meshes[0].primitives[0], material: 0 }] });
    json.nodes.push({ mesh: 1, translation: [3, 0, 0] });
    json.scenes[0].nodes = [0, 1];
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    const places = builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 0), 'VEC3');
    if (isMoving) addTrack(builder, 'translation', times, places);
    const file = { name: 'sides.glb', content: new Blob([builder.glb() as Uint8Array<ArrayBuffer>]) };
    const read = await readModel([file], () => {}, undefined, { switched: hasBothSides ? ['sides'] : [] });
    expect(read.changes.map(({ kind }) => kind)).toEqual(hasBothSides ? ['sides'] : []);
    const { model } = await buildModel(read, () => {}, new AbortController().signal);
    const sides = meshesOf(model.root).flatMap(({ material }) => [material].flat().map(({ side }) => side));
    model.dispose();
    return sides.toSorted();
  }

  test('are those of the file, also where it is drawn as one mesh', async () => {
    for (const isMoving of [false, true]) expect(await sidesOf(isMoving)).toEqual([FrontSide, DoubleSide]);
  });

  test('are both where that is asked for', async () => {
    expect(await sidesOf(true, true)).toEqual([DoubleSide, DoubleSide]);
    expect(await sidesOf(false, true)).toEqual([DoubleSide]);
  });
});

describe('the sides that cast shadows', () => {
  const CLOSED = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
  const OPEN = CLOSED.slice(0, 9);
  const INWARD = CLOSED.toReversed();

  /** The sides that cast the shadows of tetrahedrons side by side, which share a material; null is three's default. */
  async function castingOf(shapes: number[][], isMoving: boolean, material: object = {}): Promise<(number | null)[]> {
    const builder = tetrahedron();
    const { json } = builder;
    const [{ attributes }] = json.meshes[0].primitives;
    json.materials = [material];
    json.meshes = shapes.map((shape) => ({
      primitives: [{ attributes, indices: builder.accessor(Uint16Array.from(shape), 'SCALAR'), material: 0 }],
    }));
    json.nodes = shapes.map((_, mesh) => ({ mesh, translation: [3 * mesh, 0, 0] }));
    json.scenes[0].nodes = shapes.map((_, node) => node);
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    if (isMoving) addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 0), 'VEC3'));
    const { model } = await draw('casts.glb', builder.glb() as Uint8Array<ArrayBuffer>);
    const casting = meshesOf(model.root).flatMap(({ material, geometry }) => {
      if (!Array.isArray(material)) return [material.shadowSide];
      return geometry.groups.map(({ materialIndex }) => (material as Material[])[materialIndex!].shadowSide);
    });
    model.dispose();
    return casting;
  }

  test.each([false, true])(
    'are the fronts of one-sided surfaces that are open or face inward; moving: %s',
    async (isMoving) => {
      expect(await castingOf([CLOSED], isMoving)).toEqual([null]);
      expect(await castingOf([OPEN], isMoving)).toEqual([FrontSide]);
      expect(await castingOf([INWARD], isMoving)).toEqual([FrontSide]);
      expect(await castingOf([OPEN], isMoving, { doubleSided: true })).toEqual([null]);
      const both = await castingOf([OPEN, CLOSED], isMoving);
      expect(both.toSorted()).toEqual([FrontSide, null]);
    },
  );

  test.each([false, true])('are the usual ones of a body of two meshes; moving: %s', async (isMoving) => {
    const builder = tetrahedron();
    const { json } = builder;
    const [primitive] = json.meshes[0].primitives;
    const part = (corners: number[]) => ({
      ...primitive,
      indices: builder.accessor(Uint16Array.from(corners), 'SCALAR'),
    });
    json.meshes[0].primitives = [part(CLOSED.slice(0, 6)), part(CLOSED.slice(6))];
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    if (isMoving) addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 0), 'VEC3'));
    const { model } = await draw('body.glb', builder.glb() as Uint8Array<ArrayBuffer>);
    for (const { material } of meshesOf(model.root))
      expect([material].flat().map(({ shadowSide }) => shadowSide)).toEqual([null]);
    model.dispose();
  });
});

test('a one-sided glTF that is inside out says that it is seen through, and one that is right does not', async () => {
  const detailsOf = async (isInsideOut: boolean, material: object = {}) => {
    const builder = tetrahedron();
    const primitive = builder.json.meshes[0].primitives[0];
    if (isInsideOut) primitive.indices = builder.accessor(Uint16Array.of(0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2), 'SCALAR');
    builder.json.materials = [material];
    primitive.material = 0;
    const file = { name: 'box.glb', content: new Blob([builder.glb() as Uint8Array<ArrayBuffer>]) };
    return (await readModel([file], () => {})).details;
  };
  const sentence = 'its surfaces have one side, as the file says, and are seen through from outside';
  expect(await detailsOf(true)).toEqual([sentence]);
  expect(await detailsOf(false)).toEqual([]);
  expect(await detailsOf(true, { doubleSided: true })).toEqual([]);
});
