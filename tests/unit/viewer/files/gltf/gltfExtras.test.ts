import { describe, expect, test } from 'vitest';
import type { ReadModel } from '../../../../../src/viewer/files/readModel.js';
import { readModel } from '../../../../../src/viewer/files/readModel.js';
import { type GltfBuilder, tetrahedron } from '../../../../../tools/modelFiles/GltfBuilder.js';
import { colorsOf, file } from '../../../../../tools/modelFiles/modelWriters.js';

/** The corners of the model lie so far from its middle. */
const RADIUS = Math.sqrt(3);
const EYE = { type: 'perspective', name: 'hero', perspective: { yfov: Math.PI / 2, znear: 0.1, aspectRatio: 1.5 } };

/** A model 1e6 units to the right, with nodes beside it. */
function glb(nodes: object[], change: (json: GltfBuilder['json']) => void = () => {}): Uint8Array {
  const builder = tetrahedron();
  const { json } = builder;
  json.nodes = [{ mesh: 0 }, ...nodes];
  json.scenes = [{ nodes: [json.nodes.length] }];
  json.nodes.push({ translation: [1e6, 0, 0], children: json.nodes.map((_: object, i: number) => i) });
  change(json);
  return builder.glb();
}
const read = (content: Uint8Array, variant?: string | number): Promise<ReadModel> =>
  readModel([file('a.glb', content)], () => {}, undefined, { variant });
const near = (numbers: readonly number[]): number[] => numbers.map((value) => Number(value.toFixed(5)) + 0);

describe('cameras', () => {
  test('lie where the model is drawn, turned with their nodes', async () => {
    const half = Math.SQRT1_2;
    const { extras } = await read(
      glb(
        [
          { camera: 0, translation: [0, 0, 4] },
          // Looks to −x.
          { camera: 1, name: 'from the side', translation: [5, 0, 0], rotation: [0, half, 0, half], scale: [3, 3, 3] },
        ],
        (json) => {
          json.cameras = [EYE, { type: 'orthographic', orthographic: { xmag: 4, ymag: 2, znear: 0, zfar: 9 } }];
        },
      ),
    );
    const [hero, side] = extras!.cameras;
    expect(hero).toMatchObject({ name: 'hero', isOrthographic: false, aspect: 1.5 });
    expect([hero.position, hero.forwards, hero.up].map(near)).toEqual([
      near([0, 0, 4 / RADIUS]),
      [0, 0, -1],
      [0, 1, 0],
    ]);
    expect(hero.high).toBeCloseTo(1);
    expect(side).toMatchObject({ name: 'from the side', isOrthographic: true, aspect: 2 });
    expect([side.position, side.forwards].map(near)).toEqual([near([5 / RADIUS, 0, 0]), [-1, 0, 0]]);
    expect(side.high).toBeCloseTo(2 / RADIUS);
  });

  test('have names that differ; those that are damaged, hidden or not in the scene are none', async () => {
    const { extras } = await read(
      glb(
        [
          { camera: 0 },
          { camera: 0 },
          { camera: 1 },
          { camera: 2 },
          { camera: 0, extensions: { KHR_node_visibility: { visible: false } } },
          { camera: 0, scale: [0, 0, 0], translation: [1e39, 0, 0] },
        ],
        (json) => {
          json.cameras = [EYE, { type: 'perspective' }, { type: 'perspective', perspective: { yfov: 0.5 } }];
          json.nodes.push({ camera: 0 });
        },
      ),
    );
    expect(extras!.cameras.map(({ name }) => name)).toEqual(['hero', 'hero 2', 'Camera 3', 'hero 3']);
  });
});

test('lights shine from where their nodes are; those without light are none', async () => {
  const lights = [
    { type: 'directional', intensity: 3 },
    { type: 'spot', color: [1, 0, 0], intensity: 100, spot: { outerConeAngle: 0.5 } },
    { type: 'point', intensity: 0 },
    { type: 'area' },
  ];
  const { extras } = await read(
    glb(
      lights.map((_, light) => ({ translation: [0, 0, 7], extensions: { KHR_lights_punctual: { light } } })),
      (json) => {
        json.extensions = { KHR_lights_punctual: { lights } };
      },
    ),
  );
  expect(extras!.lights).toHaveLength(2);
  expect(extras!.lights[0]).toMatchObject({ kind: 'directional', intensity: 3 });
  expect(extras!.lights[1].intensity).toBeCloseTo(21.26);
  expect(extras!.lights[1].angle).toBe(0.5);
  expect(near(extras!.lights[1].position)).toEqual(near([0, 0, 7 / RADIUS]));
  expect(near(extras!.lights[1].forwards)).toEqual([0, 0, -1]);
});

describe('variants of materials', () => {
  const content = glb([], (json) => {
    json.materials = [
      [1, 1, 1],
      [1, 0, 0],
      [0, 0, 1],
    ].map((color) => ({
      pbrMetallicRoughness: { baseColorFactor: [...color, 1] },
    }));
    json.extensions = { KHR_materials_variants: { variants: [{ name: 'red' }, {}, { name: '1' }] } };
    Object.assign(json.meshes[0].primitives[0], {
      material: 0,
      extensions: {
        KHR_materials_variants: {
          mappings: [
            { material: 1, variants: [0] },
            { material: 99, variants: [0] },
            { material: 2, variants: [1, 2] },
          ],
        },
      },
    });
  });
  const colourOf = async (variant?: string | number): Promise<string> => {
    const model = await read(content, variant);
    return model.kind === 'mesh' ? colorsOf(model)[0] : '';
  };

  test('are named, and chosen by name or number', async () => {
    expect((await read(content)).extras!.variants).toEqual(['red', 'Variant 2', '1']);
    expect(await colourOf()).toBe('none');
    expect([await colourOf('red'), await colourOf('2'), await colourOf(0)]).toEqual(['255,0,0', '0,0,255', '255,0,0']);
    // A name comes before a number.
    expect(await colourOf('1')).toBe('0,0,255');
  });

  test('those that are not there are refused', async () => {
    await expect(colourOf('blue')).rejects.toThrow('a.glb has no variant blue; it has red, Variant 2, 1.');
    await expect(read(glb([]), 'red')).rejects.toThrow('a.glb has no variants of its materials.');
  });
});

test('extensions that are not read are named, and not those that change nothing', async () => {
  const said = async (...names: string[]): Promise<string[]> => {
    const builder = tetrahedron();
    builder.json.extensionsUsed = names;
    return (await read(builder.glb())).details;
  };
  expect(await said('KHR_materials_clearcoat', 'KHR_materials_unlit', 'KHR_texture_transform', 'KHR_xmp')).toEqual([]);
  expect(await said('KHR_draco_mesh_compression', 'EXT_meshopt_compression', 'KHR_mesh_quantization')).toEqual([]);
  expect(await said('KHR_materials_ior', 'VRM')).toEqual(['the glTF extension VRM is not read']);
  expect(await said('MSFT_lod', 'KHR_materials_displacement', 'MSFT_lod')).toEqual([
    'the glTF extensions MSFT_lod, KHR_materials_displacement are not read',
  ]);
  expect(await said(...'ABCDEFG')).toEqual(['the glTF extensions A, B, C, D, E, 2 more are not read']);
});
