import { expect, test } from 'vitest';
import { buildModel } from '../../../src/drawing/buildModel.js';
import { meshesOf } from '../../../src/drawing/meshesOf.js';
import { readModel } from '../../../src/files/readModel.js';
import { addTrack, tetrahedron } from '../../../tools/modelFiles/GltfBuilder.js';

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

test('a part of glTF without normals gets those of every other format, with edges kept', async () => {
  const builder = tetrahedron();
  const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
  addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 0), 'VEC3'));
  const { model } = await draw('moves.glb', builder.glb() as Uint8Array<ArrayBuffer>);
  const [mesh] = meshesOf(model.root);
  expect(mesh.material).toMatchObject({ flatShading: false });
  expect(mesh.geometry.attributes.normal.count).toBeGreaterThan(3);
  model.dispose();
});
