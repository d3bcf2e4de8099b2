import { PNG } from 'pngjs';
import { expect, test } from 'vitest';
import { NodeSurroundings } from '../../../../../src/command/draw/NodeSurroundings.js';
import { withPictures } from '../../../../../src/viewer/files/pictures/decodePictures.js';
import { readModel } from '../../../../../src/viewer/files/readModel.js';
import { GltfBuilder, type Json } from '../../../../../tools/modelFiles/GltfBuilder.js';
import { file } from '../../../../../tools/modelFiles/modelWriters.js';

/** A picture whose left half has one lightness, and whose right half another. */
function halves(left: number, right: number): Uint8Array {
  const png = new PNG({ width: 8, height: 8 });
  for (let i = 0; i < 64; i++) png.data.set([...Array(3).fill(i % 8 < 4 ? left : right), 255], 4 * i);
  return PNG.sync.write(png);
}

/** Two squares in one primitive, whose coordinates lie in the left and in the right half of a picture. */
function squares(picture: Uint8Array, material: object, transform?: object): Uint8Array {
  const builder = new GltfBuilder();
  const { json } = builder;
  const square = (x: number): number[] => [x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0];
  const uvs = (u: number): number[] => [u, 0.1, u + 0.3, 0.1, u + 0.3, 0.9, u, 0.9];
  const attributes = {
    POSITION: builder.accessor(Float32Array.from([...square(0), ...square(2)]), 'VEC3'),
    TEXCOORD_0: builder.accessor(Float32Array.from([...uvs(0.1), ...uvs(0.6)]), 'VEC2'),
  };
  const indices = builder.accessor(Uint16Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7), 'SCALAR');
  json.meshes[0].primitives = [{ attributes, indices, material: 0 }];
  const transmissionTexture = { index: 0, ...(transform && { extensions: { KHR_texture_transform: transform } }) };
  const extensions = { KHR_materials_transmission: { transmissionFactor: 1, transmissionTexture } };
  json.materials = [{ ...material, extensions }];
  json.textures = [{ source: 0 }];
  json.images = [{ bufferView: builder.view(picture), mimeType: 'image/png' }];
  return builder.glb();
}

/** The triangles of each primitive, and how opaque its material is. */
async function surfaces(glb: Uint8Array): Promise<[triangles: number, alpha: number | string][]> {
  const surroundings = new NodeSurroundings('.');
  const model = await withPictures(
    await readModel([file('a.glb', glb)], () => {}, surroundings),
    () => {},
    surroundings,
  );
  if (model.kind !== 'parts') throw new Error('It has no parts.');
  const { meshes, accessors, materials } = model.parts.json as Json;
  expect(materials.some(({ extras }: Json) => extras)).toBe(false);
  return meshes[0].primitives.map(({ indices, material }: Json) => {
    const { alphaMode = 'OPAQUE', pbrMetallicRoughness } = materials[material];
    const alpha = pbrMetallicRoughness.baseColorFactor?.[3] ?? 1;
    return [accessors[indices].count / 3, alphaMode === 'BLEND' ? Number(alpha.toFixed(2)) : alphaMode];
  });
}

test('a transmission texture makes only its transmissive triangles see-through', async () => {
  expect(await surfaces(squares(halves(255, 0), {}))).toEqual([
    [2, 'OPAQUE'],
    [2, 0.2],
  ]);
  expect(await surfaces(squares(halves(255, 255), {}))).toEqual([[4, 0.2]]);
  expect(await surfaces(squares(halves(0, 0), {}))).toEqual([[4, 'OPAQUE']]);
  expect(await surfaces(squares(halves(128, 0), {}))).toEqual([
    [2, 'OPAQUE'],
    [2, 0.6],
  ]);
});

test('a picture is placed as its texture is, and blending counts besides', async () => {
  expect(await surfaces(squares(halves(255, 0), {}, { offset: [0.5, 0], scale: [0.5, 1] }))).toEqual([[4, 'OPAQUE']]);
  expect(await surfaces(squares(halves(0, 255), {}, { offset: [0.5, 0], scale: [0.5, 1] }))).toEqual([[4, 0.2]]);
  const half = { alphaMode: 'BLEND', pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 0.5] } };
  expect(await surfaces(squares(halves(255, 255), half))).toEqual([[4, 0.1]]);
});
