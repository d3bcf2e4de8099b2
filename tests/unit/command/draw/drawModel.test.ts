import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { drawSVG } from 'three-hatching/svg';
import { describe, expect, test } from 'vitest';
import { NodeSurroundings } from '../../../../src/command/draw/NodeSurroundings.js';
import { settingsFor, setUpScene } from '../../../../src/command/draw/setUpScene.js';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { packGlb } from '../../../../tools/modelFiles/columnModel.js';
import { tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';
import {
  octahedronAsciiStl,
  octahedronBin,
  octahedronBinaryStl,
  octahedronDracoGlb,
  octahedronGlb,
  octahedronGltf,
  octahedronMeshoptGlb,
  octahedronObj,
  octahedronPly,
  skyPng,
  squareMtl,
  squareObj,
} from '../../../../tools/modelFiles/modelFiles.js';
import { draw, optionsOf, refusal, SMALL, useWorkFolder, work } from './drawing.js';

useWorkFolder();

/** A picture in a format that only browsers decode: its header is all that is read. */
const GIF = Buffer.from(`474946383961040004008000000000ffffff2c0000000004000400000202${'00'.repeat(8)}`, 'hex');

/** One that is decoded here, too. */
const JPEG = Buffer.from(
  '/9j/4AAQSkZJRgABAQAAAQABAAD/2wCEAAMDAwMDAwQEBAQFBQUFBQcHBgYHBwsICQgJCAsRCwwLCwwLEQ8SDw4PEg8bFRMTFRsfGhkaHyYiIiYwLTA+PlQBAwMDAwMDBAQEBAUFBQUFBwcGBgcHCwgJCAkICxELDAsLDAsRDxIPDg8SDxsVExMVGx8aGRofJiIiJjAtMD4+VP/CABEIABAAEAMBEQACEQEDEQH/xAAqAAEBAQAAAAAAAAAAAAAAAAAKBwkBAQEBAAAAAAAAAAAAAAAAAAkGB//aAAwDAQACEAMQAAAAg+RIxt7rpznaRiSRKc9b/8QAFBABAAAAAAAAAAAAAAAAAAAAIP/aAAgBAQABPwAf/8QAFBEBAAAAAAAAAAAAAAAAAAAAIP/aAAgBAgEBPwAf/8QAFBEBAAAAAAAAAAAAAAAAAAAAIP/aAAgBAwEBPwAf/9k=',
  'base64',
);

describe('a model of every format is drawn', () => {
  const GLB = octahedronGlb();

  test.each([
    ['a.obj', octahedronObj],
    ['a.ply', octahedronPly],
    ['text.stl', octahedronAsciiStl],
    ['a.stl', octahedronBinaryStl()],
    ['a.glb', GLB],
  ])('%s', async (name, content) => {
    const { svgs, isWhole } = await draw(name, content, '--no-shadows');
    expect(isWhole).toBe(true);
    expect(svgs).toHaveLength(1);
    expect(svgs[0]).toMatch(/^<\?xml|^<svg/);
    expect(svgs[0]).toContain('width="100mm" height="100mm"');
    expect(svgs[0].match(/<path/g)!.length).toBeGreaterThan(50);
  });

  test('the same shape gives the same lines, packed or not', { tags: ['all'] }, async () => {
    const [{ svgs: plain }, { svgs: draco }, { svgs: meshopt }] = [
      await draw('a.glb', GLB, '--no-shadows'),
      await draw('b.glb', await octahedronDracoGlb(), '--no-shadows'),
      await draw('c.glb', await octahedronMeshoptGlb(), '--no-shadows'),
    ];
    const lengthOf = (svg: string): number => svg.match(/<path/g)!.length;
    for (const [svg] of [draco, meshopt]) expect(Math.abs(lengthOf(svg) / lengthOf(plain[0]) - 1)).toBeLessThan(0.05);
  });

  test('finds files beside the model by path or by name', async () => {
    mkdirSync(join(work, 'parts'));
    writeFileSync(join(work, 'parts/a b.bin'), octahedronBin());
    expect((await draw('a.gltf', octahedronGltf('parts/a%20b.bin'), ...SMALL)).svgs).toHaveLength(1);
    writeFileSync(join(work, 'c.bin'), octahedronBin());
    expect((await draw('b.gltf', octahedronGltf('C:\\models\\c.bin'), ...SMALL)).svgs).toHaveLength(1);
  });

  test('reads no files outside the model’s folder, and fetches nothing', async () => {
    mkdirSync(join(work, 'inner'));
    writeFileSync(join(work, 'out.bin'), octahedronBin());
    const sentence = 'inner/a.gltf needs out.bin; put both files into one folder.';
    for (const uri of ['../out.bin', `${work}/out.bin`, 'https://example.org/out.bin'])
      expect(await refusal('inner/a.gltf', octahedronGltf(uri))).toBe(sentence.replace('inner/', ''));
  });
});

test('the drawing is that of drawSVG for a scene staged in the same way, byte for byte', {
  tags: ['all'],
}, async () => {
  const args = ['--pen', '0.4', '--sheet', '60x45', '--margin', '5', '--view', '20 30', '--light', '-60 35'];
  const options = optionsOf(...args);
  const { svgs } = await draw('a.glb', octahedronGlb(), ...args);
  const surroundings = new NodeSurroundings(work);
  const read = await readModel(
    [{ name: 'a.glb', content: new Blob([octahedronGlb() as Uint8Array<ArrayBuffer>]) }],
    () => {},
    surroundings,
  );
  const { signal } = new AbortController();
  const { model } = await buildModel(read, () => {}, signal);
  const drawnWith = settingsFor(options, undefined, read.upAxis);
  const { scene, placed, placeLights } = await setUpScene(model, drawnWith, options, [0], {
    signal,
    report: () => {},
  });
  placeLights();
  const { svg } = await drawSVG(scene, placed.camera, { kind: 'pen', penWidth: 0.4, sheet: [60, 45], margin: 5 });
  expect(svgs).toEqual([svg]);
});

describe('--format', () => {
  test('is overruled by the content, and a sentence says so', async () => {
    const said = async (...args: string[]): Promise<string[]> =>
      (await draw('a.dat', octahedronBinaryStl(), ...SMALL, ...args)).notes;
    expect(await said()).toEqual([]);
    expect(await said('--format', 'stl')).toEqual([]);
    expect(await said('--format', 'obj')).toEqual(['a.dat: read as STL, which its content is, and not as OBJ.']);
  });

  test('is not part of the file name in error messages', async () => {
    expect(await refusal('a.dat', '', '--format', 'stl')).toBe('a.dat is empty.');
    expect(await refusal('b.dat', 'solid', '--format', 'stl')).toBe(
      'b.dat is not an STL file inside, or it was cut short.',
    );
  });
});

describe('pictures', () => {
  test('PNG and JPEG are decoded; other formats are named, and the drawing is made without their colours', async () => {
    writeFileSync(join(work, 'square.mtl'), squareMtl);
    writeFileSync(join(work, 'sky.png'), skyPng());
    const good = await draw('a.obj', squareObj, '--view', '0 0', ...SMALL);
    expect(good.isWhole).toBe(true);
    expect(good.notes.filter((note) => /PNG/.test(note))).toEqual([]);
    writeFileSync(join(work, 'sky.png'), JPEG);
    const other = await draw('a.obj', squareObj, '--view', '0 0', ...SMALL);
    expect([other.isWhole, other.notes]).toEqual([true, good.notes]);
    expect(other.svgs[0]).not.toBe(good.svgs[0]);
    writeFileSync(join(work, 'sky.png'), GIF);
    const lacking = await draw('b.obj', squareObj, '--view', '0 0', ...SMALL);
    expect(lacking.svgs).toHaveLength(1);
    expect(lacking.isWhole).toBe(false);
    expect(lacking.notes).toEqual([
      'b.obj is drawn without its pictures in GIF, which are not read here; save them as PNG.',
    ]);
  });

  test('draws nothing if a picture that cuts out a surface is missing', async () => {
    const json = JSON.parse(octahedronGltf());
    const uri = `data:image/gif;base64,${GIF.toString('base64')}`;
    json.images = [{ uri }];
    json.textures = [{ source: 0 }];
    json.materials = [{ alphaMode: 'MASK', pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
    json.meshes[0].primitives[0].material = 0;
    expect(await refusal('leaf.glb', packGlb(JSON.stringify(json), octahedronBin()))).toBe(
      'leaf.glb has surfaces that are cut out by pictures in GIF, which are not read here; save them as PNG.',
    );
  });

  test('reports each missing or damaged picture once, and the drawing as incomplete', async () => {
    const json = JSON.parse(octahedronGltf());
    json.images = [{ uri: 'a.png' }, { uri: 'b.jpg' }, { uri: 'c.jpg' }];
    json.textures = [0, 1, 2].map((source) => ({ source }));
    json.materials = [0, 1, 2].map((index) => ({ pbrMetallicRoughness: { baseColorTexture: { index } } }));
    const [primitive] = json.meshes[0].primitives;
    json.meshes = [0, 1, 2, 0].map((material) => ({ primitives: [{ ...primitive, material }] }));
    json.nodes = json.meshes.map((_: unknown, mesh: number) => ({ mesh }));
    json.scenes = [{ nodes: [0, 1, 2, 3] }];
    writeFileSync(join(work, 'c.jpg'), JPEG.subarray(0, 120));
    const glb = packGlb(JSON.stringify(json), octahedronBin());
    const { notes, isWhole, svgs } = await draw('parts.glb', glb, ...SMALL);
    expect(svgs).toHaveLength(1);
    expect(isWhole).toBe(false);
    expect(notes.filter((note) => /a\.png|b\.jpg|picture|map/.test(note))).toEqual([
      'parts.glb: a.png is missing; put it beside the model.',
      'parts.glb: b.jpg is missing; put it beside the model.',
      expect.stringMatching(/^parts\.glb: 1 (damaged )?picture left out/),
    ]);
  });

  test('reports a glTF image that is not a picture, and the drawing as incomplete', async () => {
    const json = JSON.parse(octahedronGltf());
    json.images = [{ uri: 'a.png' }];
    json.textures = [{ source: 0 }];
    json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
    json.meshes[0].primitives[0].material = 0;
    writeFileSync(join(work, 'a.png'), 'This is text, which has the name of a picture.');
    const { notes, isWhole } = await draw('a.glb', packGlb(JSON.stringify(json), octahedronBin()), ...SMALL);
    expect([notes, isWhole]).toEqual([['a.glb: 1 picture left out: not PNG, JPEG or WebP.'], false]);
  });

  test('a texture of an OBJ that is missing is told, and without its colours nothing is missing', async () => {
    writeFileSync(join(work, 'square.mtl'), squareMtl);
    const { notes, isWhole } = await draw('a.obj', squareObj, ...SMALL);
    expect([notes, isWhole]).toEqual([['a.obj: sky.png is missing; put it beside the model.'], false]);
  });
});

test.each([
  [
    'corner.obj',
    octahedronObj.replace(/^f .*$/m, (face) => `v nan 0 0\n${face}\nf 1 2 -1`),
    /^corner\.obj: 1 triangle without three valid corners left out\.$/,
  ],
  ['corner.stl', octahedronAsciiStl.replace(/vertex \S+/, 'vertex nan'), /^corner\.stl: 1 triangle /],
  ['corner.ply', octahedronPly.replace(/(end_header\n)\S+/, '$1nan'), /^corner\.ply: \d triangles? without /],
])('a face with a corner that is no number is told: %s', async (name, content, sentence) => {
  const { notes, svgs } = await draw(name, content, ...SMALL);
  expect(svgs).toHaveLength(1);
  expect(notes).toEqual(expect.arrayContaining([expect.stringMatching(sentence)]));
});

test('hidden outlines and an animation are those of drawSVG', async () => {
  const { svgs } = await draw('a.obj', octahedronObj, '--hidden', 'dashed', '--animate', '3', ...SMALL);
  expect(svgs[0]).toMatch(/inkscape:label="\d+ hidden/);
  expect(svgs[0]).toContain('prefers-reduced-motion');
  const { svgs: plain } = await draw('b.obj', octahedronObj, ...SMALL);
  expect(plain[0]).not.toMatch(/inkscape:label="\d+ hidden|prefers-reduced-motion/);
});

describe('what is done to a file', () => {
  test('is left on request, and both sides are drawn', async () => {
    const builder = tetrahedron();
    const inward = Uint16Array.of(0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2);
    builder.json.meshes[0].primitives[0].indices = builder.accessor(inward, 'SCALAR');
    const glb = builder.glb();
    expect((await draw('room.glb', glb, ...SMALL)).notes).toEqual([
      'room.glb: its surfaces have one side, as the file says, and are seen through from outside.',
    ]);
    expect((await draw('room.glb', glb, ...SMALL, '--both-sides')).notes).toEqual([
      'room.glb: surfaces are drawn from both sides, also one-sided ones.',
    ]);
    const linked = await draw('room.glb', glb, ...SMALL, '--link', '#technique=engraving&switched=sides');
    expect(linked.notes).toEqual(['room.glb: surfaces are drawn from both sides, also one-sided ones.']);
    const obj = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n';
    expect((await draw('inside.obj', obj, ...SMALL)).notes).toEqual([
      'inside.obj: 4 triangles that faced inward turned around.',
    ]);
    expect((await draw('inside.obj', obj, ...SMALL, '--as-written', 'orientation,up')).notes).toEqual([]);
  });
});
