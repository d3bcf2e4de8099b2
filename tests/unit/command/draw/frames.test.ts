import { describe, expect, test } from 'vitest';
import { columnGlb } from '../../../../tools/modelFiles/columnModel.js';
import { tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';
import { octahedronGlb, octahedronGltf, octahedronObj } from '../../../../tools/modelFiles/modelFiles.js';
import { dae, fbx } from '../../../../tools/modelFiles/sceneWriters.js';
import { draw, refusal, SMALL, useWorkFolder } from './drawing.js';

useWorkFolder();

describe('frames', () => {
  test('orbit the model, and the light stays with the model', {
    tags: ['all'],
  }, async () => {
    const args = ['--frames', '4', '--view', '0 0', '--light', '0 60', '--sheet', '40x40'];
    const { svgs } = await draw('a.glb', octahedronGlb(), ...args);
    expect(new Set(svgs).size).toBe(4);
    const { svgs: again } = await draw('b.glb', octahedronGlb(), ...args);
    expect(again).toEqual(svgs);
  });

  test('have the same tone and the same size when the shape and its light are the same from all sides', {
    tags: ['all'],
  }, async () => {
    // The octahedron is the same every quarter of a turn, and without reflected light none of its planes is lit from one side.
    const { drawn } = await draw(
      'a.obj',
      octahedronObj,
      '--link',
      'technique=engraving&reflectedLight=0',
      '--frames',
      '4',
      '--view',
      '10 20',
      '--light',
      '0 89',
      '--no-shadows',
      '--pen',
      '0.3',
    );
    for (const length of drawn) expect(Math.abs(length / drawn[0] - 1)).toBeLessThan(0.04);
  });

  test('show a clip instead of a turn, and an unknown clip is an error', async () => {
    const glb = columnGlb();
    expect(await refusal('a.glb', glb, '--clip', 'Dance', '--frames', '2')).toMatch(
      /a\.glb has no clip(s\.| Dance; it has )/,
    );
    expect(await refusal('b.obj', octahedronObj, '--clip', 'Dance')).toBe('b.obj has no clips.');
  });

  test.each<[string, string]>([
    ['a.fbx', fbx(7300, true)],
    ['a.dae', dae(undefined, true)],
  ])('show the clip of %s', async (name, content) => {
    const { svgs, notes } = await draw(name, content, '--clip', '1', '--frames', '2', ...SMALL);
    expect([svgs.length, notes]).toEqual([2, []]);
  });
});

test.each([
  ['empty.obj', '', 'empty.obj is empty.'],
  ['noise.glb', Buffer.from('glTF and then nothing'), /^noise\.glb /],
  ['cut.glb', octahedronGlb().subarray(0, 300), /^cut\.glb is cut short/],
  ['nan.obj', 'v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n', /nan\.obj: None of the triangles/],
  ['flat.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n', /flat\.obj: There is nothing to draw/],
  ['cycle.gltf', '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]}', /^cycle\.gltf /],
  ['a.txt', 'Dear all,', /^a\.txt is not a model that can be read here; it takes GLB/],
  ['a.blend', 'BLENDER-v300', 'a.blend is a Blender file, which is not read here; save it as GLB, say.'],
  ['a.gltf', octahedronGltf('alone.bin'), 'a.gltf needs alone.bin; put both files into one folder.'],
])('%s is refused in a sentence that names it', async (name, content, sentence) => {
  const said = await refusal(name, content);
  expect(said).toMatch(sentence);
  expect(said).toContain(name);
  expect(said).toMatch(/^\S[^\n]*\.$/);
  expect(said).not.toMatch(/this page|drop |browser has/);
});

describe('what a glTF file offers', () => {
  const named = (): Uint8Array => {
    const builder = tetrahedron();
    const { json } = builder;
    json.cameras = [{ type: 'perspective', name: 'hero', perspective: { yfov: 0.9, znear: 0.1 } }];
    json.nodes.push({ camera: 0, translation: [0, 0, 6] });
    json.scenes[0].nodes = [0, 1];
    json.materials = [{}, { pbrMetallicRoughness: { baseColorFactor: [0, 0, 0, 1] } }];
    json.extensions = { KHR_materials_variants: { variants: [{ name: 'white' }, { name: 'black' }] } };
    const mappings = [{ material: 1, variants: [1] }];
    Object.assign(json.meshes[0].primitives[0], { extensions: { KHR_materials_variants: { mappings } } });
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    const places = builder.accessor(new Float32Array(6), 'VEC3');
    json.animations = ['walk', 'run'].map((name) => ({
      name,
      channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
      samplers: [{ input: times, output: places }],
    }));
    return builder.glb();
  };

  test('is reported if no option selects it', async () => {
    const others = [
      'a.glb has the variants white, black: --variant draws with one.',
      'a.glb has the clips walk, run: --clip draws with one.',
    ];
    const { notes } = await draw('a.glb', named(), ...SMALL, '--view', 'front');
    expect(notes).toEqual(['a.glb has the camera hero: --camera draws with it.', ...others]);
    // The only camera draws without being asked for.
    expect((await draw('a.glb', named(), ...SMALL)).notes).toEqual(others);
  });

  test.each([
    [2, []],
    [3, ['a.glb has 1 light that is not drawn: the brightest two are, at most.']],
    [4, ['a.glb has 2 lights that are not drawn: the brightest two are, at most.']],
  ])('is said of more than two lights: of %i', async (count, notes) => {
    const builder = tetrahedron();
    const { json } = builder;
    const lights = Array.from({ length: count }, (_, i) => ({ type: 'point', intensity: 50 + i }));
    json.extensions = { KHR_lights_punctual: { lights } };
    const nodes = lights.map((_, light) => ({
      translation: [0, 3, 3],
      extensions: { KHR_lights_punctual: { light } },
    }));
    json.nodes = [{ mesh: 0 }, ...nodes];
    json.scenes = [{ nodes: [...json.nodes.keys()] }];
    expect((await draw('a.glb', builder.glb(), ...SMALL)).notes).toEqual(notes);
  });

  test('is drawn as a link has it, unless options say otherwise', async () => {
    const draws = (hash: string, ...more: string[]) =>
      draw('a.glb', named(), ...SMALL, '--camera', '1', '--link', `#preset=pen&${hash}`, ...more);
    const black = await draws('variant=2&clip=2');
    expect(black.notes).toEqual([]);
    const white = await draws('variant=2&clip=2', '--variant', 'white');
    expect(black.drawn[0]).toBeGreaterThan(1.2 * white.drawn[0]);
    // What is not there is nothing.
    expect((await draws('variant=9&clip=9')).drawn).toEqual(white.drawn);
  });

  test('is drawn if an option selects it', async () => {
    const chosen = ['--camera', '1', '--variant', 'black', '--clip', '2'];
    const white = await draw('a.glb', named(), ...SMALL, ...chosen.with(3, '1'));
    const black = await draw('a.glb', named(), ...SMALL, ...chosen);
    expect([white.notes, black.notes]).toEqual([[], []]);
    expect(black.drawn[0]).toBeGreaterThan(1.2 * white.drawn[0]);
    expect(await refusal('a.glb', named(), '--camera', 'side')).toBe('a.glb has no camera side; it has hero.');
    expect(await refusal('a.obj', octahedronObj, '--camera', '1')).toBe('a.obj has no cameras.');
    expect(await refusal('a.obj', octahedronObj, '--variant', '1')).toBe('a.obj has no variants of its materials.');
  });
});
