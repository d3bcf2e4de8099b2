import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type BufferGeometry, type Mesh, type PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { HatchingMaterial } from 'three-hatching';
import { drawSVG } from 'three-hatching/svg';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import type { DrawingOptions } from '../../../../src/command/DrawingOptions.js';
import type { DrawMessage } from '../../../../src/command/DrawThread.js';
import { drawModel } from '../../../../src/command/draw/drawModel.js';
import { failure } from '../../../../src/command/draw/failure.js';
import { NodeSurroundings } from '../../../../src/command/draw/NodeSurroundings.js';
import { settingsFor } from '../../../../src/command/draw/settingsFor.js';
import { stageModel } from '../../../../src/command/draw/stageModel.js';
import { parseDrawing } from '../../../../src/command/parseDrawing.js';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { columnGlb, packGlb } from '../../../../tools/modelFiles/columnModel.js';
import { addTrack, tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';
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
import { dae, fbx } from '../../../../tools/modelFiles/sceneWriters.js';
import { pathsOf, ringsOf } from '../../vector/paths.js';

let work: string;
beforeEach(() => {
  work = mkdtempSync(join(tmpdir(), 'three-hatching-'));
});
afterEach(() => rmSync(work, { recursive: true, force: true }));

const optionsOf = (...args: string[]): DrawingOptions => {
  const small = args.includes('--sheet') ? [] : ['--sheet', '100x100'];
  const request = parseDrawing(['a', '--out', 'b', ...small, ...args]);
  if (request.action !== 'draw') throw new Error('It asks for help.');
  return request.options;
};

/** A sheet that is soon drawn. */
const SMALL = ['--sheet', '40x40', '--no-shadows'] as const;

interface Drawn {
  svgs: string[];
  notes: string[];
  isWhole: boolean;
  drawn: number[];
}

/** Draws a file that is written first. */
async function draw(name: string, content: string | Uint8Array, ...args: string[]): Promise<Drawn> {
  writeFileSync(join(work, name), content);
  const messages: DrawMessage[] = [];
  const isWhole = await drawModel({ model: join(work, name), options: optionsOf(...args) }, (message) =>
    messages.push(message),
  );
  const drawings = messages.flatMap((message) => (message.kind === 'drawing' ? [message] : []));
  return {
    svgs: drawings.map(({ svg }) => svg),
    drawn: drawings.map(({ counts }) => counts.drawn),
    notes: messages.flatMap((message) => (message.kind === 'note' ? [message.sentence] : [])),
    isWhole,
  };
}

const refusal = async (name: string, content: string | Uint8Array, ...args: string[]): Promise<string> => {
  const error = await draw(name, content, ...args).then(
    () => new Error('It was drawn.'),
    (reason) => reason,
  );
  return failure(join(work, name), error);
};

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
  const { scene, placed, placeLights } = await stageModel(model, drawnWith, options, [0], {
    signal,
    report: () => {},
  });
  placeLights();
  const { svg } = await drawSVG(scene, placed.camera, { kind: 'pen', penWidth: 0.4, sheet: [60, 45], margin: 5 });
  expect(svgs).toEqual([svg]);
});

describe('the stage', () => {
  async function staged(args: readonly string[], link?: string, glb?: Uint8Array<ArrayBuffer>) {
    const options = optionsOf(...args, ...(link ? ['--link', link] : []));
    const content = new Blob([glb ?? octahedronObj]);
    const name = glb ? 'a.glb' : 'a.obj';
    const read = await readModel([{ name, content }], () => {}, new NodeSurroundings(work));
    const { signal } = new AbortController();
    const { model } = await buildModel(read, () => {}, signal);
    const drawnWith = settingsFor(options, options.link, 'y');
    const stage = await stageModel(model, drawnWith, options, [0], { signal, report: () => {} });
    stage.placeLights();
    return { ...stage, settings: drawnWith.settings };
  }
  const degrees = (place: Vector3): number[] => {
    const { theta, phi } = new Spherical().setFromVector3(place);
    return [(180 * theta) / Math.PI, 90 - (180 * phi) / Math.PI].map((angle) => Math.round(10 * angle) / 10);
  };

  /** A model with a camera above its right side, which sees to its left and right, and with two lights. @param moves so that it stays a scene */
  function seenAndLit(moves: boolean): Uint8Array<ArrayBuffer> {
    const builder = tetrahedron();
    const { json } = builder;
    const turned = (about: number[], angle: number): number[] => [
      ...about.map((value) => value * Math.sin(angle / 2)),
      Math.cos(angle / 2),
    ];
    const light = (index: number): object => ({ KHR_lights_punctual: { light: index } });
    json.cameras = [{ type: 'perspective', perspective: { yfov: 0.6, znear: 0.1, aspectRatio: 2 } }];
    json.extensions = {
      KHR_lights_punctual: {
        lights: [{ type: 'directional', intensity: 2 }, { type: 'point', intensity: 90 }, { type: 'directional' }],
      },
    };
    json.nodes.push(
      { name: 'side', camera: 0, translation: [9, 0, 0], rotation: turned([0, 1, 0], Math.PI / 2) },
      { rotation: turned([1, 0, 0], -Math.PI / 3), extensions: light(0) },
      { translation: [-3, 0, 0], extensions: light(1) },
      { extensions: light(2) },
    );
    json.scenes[0].nodes = json.nodes.map((_: object, i: number) => i);
    if (moves)
      addTrack(
        builder,
        'translation',
        builder.accessor(Float32Array.of(0, 1), 'SCALAR'),
        builder.accessor(new Float32Array(6), 'VEC3'),
      );
    return builder.glb() as Uint8Array<ArrayBuffer>;
  }

  test.each([false, true])('has the eye and the lights of a glTF file, moving: %s', async (moves) => {
    const glb = seenAndLit(moves);
    const { placed, lights, settings } = await staged(['--camera', 'side', '--sheet', '60x60'], undefined, glb);
    const { camera } = placed as { camera: PerspectiveCamera };
    expect(camera.position.x).toBeCloseTo(9 / Math.sqrt(3), 4);
    expect(placed.target.length()).toBeCloseTo(0, 5);
    // All that it sees to the sides is on a sheet that is as high as wide.
    expect(Math.tan((camera.fov * Math.PI) / 360)).toBeCloseTo(2 * Math.tan(0.3), 5);
    // The lamp of 90 at a distance of √3 radii gives more light than the sun.
    expect([settings.lightKind, settings.secondLight]).toEqual(['point', 'free']);
    expect([degrees(lights.position), degrees(lights.secondPosition)]).toEqual([
      [-90, 0],
      [0, 60],
    ]);
    const found = await staged(['--no-file-lights', '--view', '0 0'], undefined, glb);
    expect(found.settings.lightKind).toBe('directional');
    const own = await staged(['--light', '10 20'], undefined, glb);
    expect(degrees(own.lights.position)).toEqual([10, 20]);
  });

  test.each([
    ['top', [0, 1, 0], [1, 0, 0], [0, 0, -1]],
    ['0 -90', [0, -1, 0], [1, 0, 0], [0, 0, 1]],
    ['90 90', [0, 1, 0], [0, 0, -1], [-1, 0, 0]],
    ['left', [-1, 0, 0], [0, 0, 1], [0, 1, 0]],
  ])('from %s is seen exactly, with and without perspective', async (view, toEye, right, up) => {
    for (const args of [[], ['--orthographic']]) {
      const { placed, scene } = await staged(['--view', view, '--no-shadows', ...args]);
      const { camera, target } = placed;
      camera.updateMatrixWorld();
      scene.updateMatrixWorld();
      const axes = [new Vector3(), new Vector3(), new Vector3()];
      camera.matrixWorld.extractBasis(axes[0], axes[1], axes[2]);
      for (const [i, expected] of [right, up, toEye].entries())
        for (const k of [0, 1, 2]) expect(axes[i].getComponent(k)).toBeCloseTo(expected[k], 6);
      const seen = camera.position.clone().sub(target).normalize();
      for (const k of [0, 1, 2]) expect(seen.getComponent(k)).toBeCloseTo(toEye[k], 6);
    }
  });

  test('chooses the orientation of the sheet by the model, unless an option does', async () => {
    const wide = 'v -3 0 0\nv 3 0 0\nv 0 1 0.2\nv 0 0 -0.3\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n';
    const high = wide.replaceAll(/v (\S+) (\S+)/g, 'v $2 $1');
    const sizeOf = async (content: string, sheet: string): Promise<string> => {
      const { svgs } = await draw('a.obj', content, '--sheet', sheet, '--view', 'front', '--no-shadows', '--dpi', '20');
      return /width="([\d.]+)mm" height="([\d.]+)mm"/.exec(svgs[0])!.slice(1).join(' ');
    };
    expect(await sizeOf(wide, 'A6')).toBe('148 105');
    expect(await sizeOf(high, 'A6')).toBe('105 148');
    expect(await sizeOf(wide, 'A6 portrait')).toBe('105 148');
    expect(await sizeOf(high, '5x3in')).toBe('127 76.2');
  });

  test('has a shadow that ends on the sheet where it would be cut, and as the look says elsewhere', async () => {
    const fadeOf = async (...args: string[]): Promise<number> => {
      const { scene } = await staged(['--view', '0 20', ...args]);
      return (scene.getObjectByName('ground') as Mesh<BufferGeometry, HatchingMaterial>).material.shadowFade;
    };
    const usual = await fadeOf('--light', '30 70');
    expect(usual).toBe(0.65);
    for (const lens of [[], ['--orthographic']]) {
      expect(await fadeOf('--light', '80 12', ...lens)).toBeGreaterThan(1.2 * usual);
      expect(await fadeOf('--light', '-80 6', ...lens)).toBeGreaterThan(1.2 * usual);
    }
  });

  test('has a shadow that has no line at the margins, however low the light, seen as one likes', {
    tags: ['all'],
  }, async () => {
    const post = (x: number, width: number, height: number): number[][] =>
      [0, 1].flatMap((up) =>
        [
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([dx, dz]) => [x + dx * width, up * height, dz * width]),
      );
    const corners = [...post(0, 0.05, 3), ...post(0, 0.3, 0.1)];
    const faces = [
      [0, 1, 2, 3],
      [7, 6, 5, 4],
      [0, 4, 5, 1],
      [1, 5, 6, 2],
      [2, 6, 7, 3],
      [3, 7, 4, 0],
    ];
    const lamp = [
      ...corners.map((corner) => `v ${corner.join(' ')}`),
      ...[0, 8].flatMap((first) => faces.map((face) => `f ${face.map((i) => first + i + 1).join(' ')}`)),
    ].join('\n');
    const views = [[], ['--view', '30 50'], ['--orthographic']];
    for (const [i, sheet] of ['60x40', '40x60'].entries())
      for (const [k, light] of ['90 8', '-90 8', '0 8', '135 25'].entries()) {
        const view = views[(i + k) % 3];
        const { svgs } = await draw('lamp.obj', lamp, '--sheet', sheet, '--margin', '4', '--light', light, ...view);
        const [width, height] = sheet.split('x').map(Number);
        const points = pathsOf(svgs[0]).flatMap(ringsOf).flat();
        expect(points.length).toBeGreaterThan(500);
        const near = points.filter((place, i) => Math.min(place - 4, (i % 2 === 0 ? width : height) - 4 - place) < 0.2);
        expect(near, `${sheet} ${light} ${view}`).toEqual([]);
      }
  });

  test('places eye and light by the options', async () => {
    const { placed, lights } = await staged(['--view', '25 8', '--light', '-45 40']);
    expect(degrees(placed.camera.position.clone().sub(placed.target))).toEqual([25, 8]);
    expect(degrees(lights.position)).toEqual([-45, 40]);
  });

  test('lights the model for its view if no option or link places the light', async () => {
    const [front, back] = [await staged(['--view', '0 10']), await staged(['--view', '180 10'])];
    expect(front.lights.position.z).toBeGreaterThan(0);
    expect(back.lights.position.z).toBeLessThan(0);
  });

  test('shows all of the model, with and without perspective, on any sheet', {
    tags: ['all'],
  }, async () => {
    for (const args of [[], ['--orthographic'], ['--sheet', '50x200'], ['--sheet', '200x50', '--orthographic']]) {
      const { placed, scene } = await staged([...args, '--no-shadows']);
      placed.camera.updateMatrixWorld();
      scene.updateMatrixWorld();
      const corners = [0, 1, 2].flatMap((axis) => [-1, 1].map((sign) => new Vector3().setComponent(axis, sign)));
      const reach = Math.max(
        ...corners.flatMap((corner) => {
          const { x, y } = corner.project(placed.camera);
          return [Math.abs(x), Math.abs(y)];
        }),
      );
      expect(reach).toBeLessThan(1);
      expect(reach).toBeGreaterThan(0.9);
    }
  });

  test('takes look, view and light from a link, but not its model', async () => {
    const link = 'model=dragon1&technique=engraved&lineSpacing=9&lightAzimuth=12&camera=3,1,2,0.5,0,0&ink=%23203080';
    const { placed, lights, settings } = await staged([], link);
    expect(placed.camera.position.toArray()).toEqual([3, 1, 2]);
    expect(placed.target.toArray()).toEqual([0.5, 0, 0]);
    expect(degrees(lights.position)).toEqual([12, 38]);
    expect(settings).toMatchObject({ model: 'file', lineSpacing: 9, ink: '#203080', shadows: 'off' });
    const other = await staged(['--view', '0 0', '--light', '5 6', '--preset', 'banknote', '--shadows'], link);
    expect(degrees(other.placed.camera.position.clone().sub(other.placed.target))).toEqual([0, 0]);
    expect(other.settings).toMatchObject({ lightAzimuth: 5, lightElevation: 6, shadows: 'on', ink: '#18332f' });
  });

  test('has the hatched field behind it that a link asks for', async () => {
    const link = 'technique=engraved&shadows=off&background=on';
    const { svgs } = await draw('a.obj', octahedronObj, '--link', link, '--sheet', '50x50', '--kind', 'pen');
    expect(svgs[0]).toContain('background"');
  });

  test('uses the up axis of the options or of the link', () => {
    const upAxis = (args: readonly string[], link?: string): string =>
      settingsFor(optionsOf(...args), link, 'z').settings.upAxis;
    expect(upAxis([])).toBe('z');
    expect(upAxis(['--up', '-x'])).toBe('-x');
    expect(upAxis([], 'technique=engraved')).toBe('z');
    expect(upAxis([], 'technique=engraved&upAxis=y')).toBe('y');
  });

  test('has no shadow on the ground without shadows', () => {
    expect(settingsFor(optionsOf('--no-shadows'), undefined, 'y').settings).toMatchObject({
      shadows: 'off',
      ground: 'none',
    });
    expect(settingsFor(optionsOf(), undefined, 'y').settings).toMatchObject({ shadows: 'on', ground: 'shadow' });
  });
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
      'technique=engraved&reflectedLight=0',
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
    expect((await draw('a.glb', named(), ...SMALL)).notes).toEqual([
      'a.glb has the camera hero: --camera draws with it.',
      'a.glb has the variants white, black: --variant draws with one.',
      'a.glb has the clips walk, run: --clip draws with one.',
    ]);
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
