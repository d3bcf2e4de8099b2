import draco, { type Attribute } from 'draco3d';
import { expect, test, vi } from 'vitest';
import { ModelError } from '../../../../../src/viewer/files/common/ModelError.js';
import { BITMAPS } from '../../../../../src/viewer/files/common/Surroundings.js';
import { decodeDraco } from '../../../../../src/viewer/files/gltf/decodeDraco.js';
import { readModel } from '../../../../../src/viewer/files/readModel.js';
import { type DracoValues, encodeDraco } from '../../../../../tools/modelFiles/encodeDraco.js';
import { GltfBuilder } from '../../../../../tools/modelFiles/GltfBuilder.js';

/** In Node it comes from a package, not from an address. */
const load = vi.fn();
const decoder = await draco.createDecoderModule({});
load.mockResolvedValue(decoder);

const CORNERS = [1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1];
const TRIANGLES = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
const surface: Record<string, DracoValues> = {
  COLOR_0: { values: Uint8Array.of(255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255), size: 3 },
  POSITION: { values: Float32Array.from(CORNERS), size: 3 },
};
const packed = await encodeDraco(surface, TRIANGLES);

/** A glTF file with the packed surface. */
async function read(bytes: Uint8Array, ids: Record<string, number> = packed.ids) {
  const builder = new GltfBuilder();
  builder.json.accessors = [
    { componentType: 5126, type: 'VEC3', count: 4 },
    { componentType: 5121, type: 'VEC3', count: 4, normalized: true },
    { componentType: 5123, type: 'SCALAR', count: 12 },
  ];
  builder.json.meshes[0].primitives[0] = {
    attributes: { POSITION: 0, COLOR_0: 1 },
    indices: 2,
    extensions: { KHR_draco_mesh_compression: { bufferView: builder.view(bytes), attributes: ids } },
  };
  builder.json.extensionsUsed = builder.json.extensionsRequired = ['KHR_draco_mesh_compression'];
  const content = new Blob([builder.glb() as Uint8Array<ArrayBuffer>]);
  const model = await readModel([{ name: 'a.glb', content }], () => {}, { ...BITMAPS, loadDraco: load });
  if (model.kind !== 'mesh') throw new Error('It was read in parts.');
  return model;
}

/** The corners of each triangle with their colours, in no order. */
function cornersOf(positions: ArrayLike<number>, colours: ArrayLike<number>, indices: ArrayLike<number>): string[] {
  const three = (values: ArrayLike<number>, i: number) => [0, 1, 2].map((k) => values[3 * i + k]).join();
  return Array.from(indices, (i) => `${three(positions, i)}: ${three(colours, i)}`).sort();
}

test('triangles are unpacked with the values of their vertices, as their types hold them', () => {
  const { PointAttribute } = decoder as unknown as { PointAttribute: { prototype: Attribute } };
  const asked = vi.spyOn(PointAttribute.prototype, 'num_components');
  const { indices, attributes } = decodeDraco(
    decoder,
    packed.bytes,
    new Map([
      ['POSITION', { id: packed.ids.POSITION, componentType: 5126 }],
      ['COLOR_0', { id: packed.ids.COLOR_0, componentType: 5121 }],
      ['wide', { id: packed.ids.COLOR_0, componentType: 5123 }],
      // A byte cannot hold -1, and there is no such attribute.
      ['narrow', { id: packed.ids.POSITION, componentType: 5121 }],
      ['missing', { id: 77, componentType: 5126 }],
    ]),
  );
  const values = (name: string) => attributes.get(name)!.values;
  expect(cornersOf(values('POSITION'), values('COLOR_0'), indices)).toEqual(
    cornersOf(CORNERS, surface.COLOR_0.values, TRIANGLES),
  );
  expect(values('wide')).toEqual(values('COLOR_0'));
  for (const name of ['narrow', 'missing'])
    expect(attributes.get(name)).toEqual({ values: new Float32Array(), size: 0 });
  // Not even of its size is an attribute asked that there is not: that would read somewhere in memory.
  expect(asked.mock.contexts).toHaveLength(4);
  expect(asked.mock.contexts).not.toContainEqual(expect.objectContaining({ ptr: 0 }));
  asked.mockRestore();
});

test('created geometries are freed, also if a part is damaged', () => {
  const allocated = { now: 0 };
  const counting = {
    ...decoder,
    _malloc: (bytes: number) => {
      allocated.now++;
      return decoder._malloc(bytes);
    },
    _free: (address: number) => {
      allocated.now--;
      decoder._free(address);
    },
    destroy: (made: unknown) => {
      allocated.now--;
      decoder.destroy(made);
    },
  };
  for (const Made of ['Decoder', 'DecoderBuffer', 'Mesh'] as const) {
    Object.assign(counting, {
      [Made]: function make() {
        allocated.now++;
        return new decoder[Made]();
      },
    });
  }
  decodeDraco(counting, packed.bytes, new Map([['POSITION', { id: packed.ids.POSITION, componentType: 5126 }]]));
  expect(allocated.now).toBe(0);
  expect(() => decodeDraco(counting, packed.bytes.subarray(0, 40), new Map())).toThrow('Draco: ');
  expect(allocated.now).toBe(0);
});

test('more triangles than memory allows are refused before they are copied', () => {
  const many = {
    ...decoder,
    Mesh: function make() {
      return Object.assign(new decoder.Mesh(), { num_faces: () => 1e8 });
    },
    _malloc: () => {
      throw new Error('It was copied.');
    },
  };
  expect(() => decodeDraco(many as never, packed.bytes, new Map())).toThrow(/^The model has more than .* triangles/);
});

test('a glTF file gets them with its colours', async () => {
  const { mesh, notes, details } = await read(packed.bytes);
  expect(mesh.indices).toHaveLength(12);
  expect([...new Set(mesh.colors)].sort()).toEqual([0, 1]);
  expect([...notes, ...details]).toEqual([]);
});

test('a colour missing in the Draco data is left out; without positions there is nothing to draw', async () => {
  const { mesh, details } = await read(packed.bytes, { ...packed.ids, COLOR_0: 77 });
  expect(mesh.colors).toBeNull();
  expect(details).toEqual(['values that do not fit its vertices left out']);
  await expect(read(packed.bytes, { ...packed.ids, POSITION: 77 })).rejects.toThrow(/^a\.glb holds no triangles/);
});

test('a damaged part, and a decoder that cannot be fetched, are told apart', async () => {
  const damaged = 'a.glb is damaged: a part packed with Draco cannot be unpacked.';
  for (const bytes of [packed.bytes.subarray(0, 40), new Uint8Array(4), new Uint8Array(200)])
    await expect(read(bytes)).rejects.toThrow(new ModelError(damaged));
  load.mockRejectedValueOnce(new TypeError('Failed to fetch'));
  await expect(read(packed.bytes)).rejects.toThrow(
    'a.glb is packed with Draco, whose decoder could not be fetched. Look after the connection, and open it again.',
  );
});
