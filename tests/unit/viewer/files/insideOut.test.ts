import { existsSync, readFileSync } from 'node:fs';
import { DoubleSide, type Mesh } from 'three';
import { afterEach, describe, expect, test } from 'vitest';
import { parseGltf } from '../../../../src/viewer/files/gltf/parseGltf.js';
import { type ReadModel, readModel } from '../../../../src/viewer/files/readModel.js';
import { mergeScene } from '../../../../src/viewer/files/scenes/mergeScene.js';
import { BOX_CORNERS, BOX_FACES } from '../../../../tools/modelFiles/box.js';
import { boxStl, type Content, file, measure, read, triangles } from '../../../../tools/modelFiles/modelWriters.js';
import { chunk, dae, fbx, shorts, text, threeMf, wrl } from '../../../../tools/modelFiles/sceneWriters.js';

const rows = (list: readonly (readonly number[])[]): string => list.map((row) => row.join(' ')).join('\n');
const floats = (values: number[]): Uint8Array => new Uint8Array(Float32Array.from(values).buffer);
const faceTriangles = (): number[][] =>
  BOX_FACES.flatMap(([a, b, c, d]) => [
    [a, b, c],
    [a, c, d],
  ]);

/** A box in every format that promises nothing about the side of its faces. */
const WRITERS: Record<string, () => Content> = {
  'box.obj': () =>
    `${BOX_CORNERS.map((corner) => `v ${corner.join(' ')}`).join('\n')}\n${BOX_FACES.map(
      (face) => `f ${face.map((corner) => corner + 1).join(' ')}`,
    ).join('\n')}\n`,
  'box.stl': () => boxStl([0, 0, 0]),
  'box.ply': () =>
    `ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n${rows(BOX_CORNERS)}\n${rows(BOX_FACES.map((face) => [4, ...face]))}\n`,
  'box.off': () => `OFF\n8 6 0\n${rows(BOX_CORNERS)}\n${rows(BOX_FACES.map((face) => [4, ...face]))}\n`,
  'box.3mf': () => threeMf(),
  'box.fbx': () => fbx(),
  'box.dae': () => dae(),
  'box.3ds': () => {
    const faces = faceTriangles();
    const places = chunk(0x4110, shorts(BOX_CORNERS.length), floats(BOX_CORNERS.flat()));
    const list = chunk(0x4120, shorts(faces.length, ...faces.flatMap((face) => [...face, 7])));
    const box = chunk(0x4000, text('box'), chunk(0x4100, places, list));
    return chunk(0x4d4d, chunk(0x0002, [3, 0, 0, 0]), chunk(0x3d3d, box));
  },
  'box.wrl': () => wrl(),
};

/** The faces of the box that are turned. */
const WAYS: Record<string, number[]> = {
  'all faces': [0, 1, 2, 3, 4, 5],
  'half of its faces': [0, 2, 3],
  'one face': [4],
};

let turned: number[] = [];
const turn = (faces: number[]): void => {
  for (const face of faces) BOX_FACES[face].reverse();
};
afterEach(() => {
  turn(turned);
  turned = [];
});

/** The changes of a model whose triangles were turned. */
const turnedIn = ({ changes }: Pick<ReadModel, 'changes'>) => changes.filter(({ kind }) => kind === 'orientation');

/** What a writer makes with some faces turned. */
function written(write: () => Content, faces: number[]): Content {
  turned = faces;
  turn(faces);
  return write();
}

describe.each(Object.entries(WRITERS))('%s', (name, write) => {
  test('is left as it is where it is right', async () => {
    const model = await read([name, write()]);
    expect(measure(model).volume).toBeGreaterThan(1);
    expect(turnedIn(model)).toEqual([]);
  });

  test.each(Object.entries(WAYS))('with %s turned is turned back, and says so', async (_, faces) => {
    const right = measure(await read([name, write()])).volume;
    const model = await read([name, written(write, faces)]);
    expect(measure(model).volume).toBeCloseTo(right, 5);
    expect(triangles(model)).toBe(12);
    expect(turnedIn(model)).toHaveLength(1);
  });
});

describe.each([
  ['box.fbx', () => fbx(7300, true)],
  ['box.dae', () => dae(undefined, true)],
] as const)('%s in motion', (name, write) => {
  const volumeOf = async (content: Content, switched: readonly 'orientation'[] = []) => {
    const model = await readModel([file(name, content)], () => {}, undefined, { switched });
    if (model.kind !== 'parts') throw new Error('It is drawn at rest.');
    const { root } = await parseGltf(model.parts);
    const sides = (root.getObjectsByProperty('isMesh', true) as Mesh[]).map(
      ({ material }) => [material].flat()[0].side,
    );
    expect(new Set(sides)).toEqual(new Set([DoubleSide]));
    return { volume: measure({ mesh: mergeScene(root) } as never).volume, changes: model.changes };
  };

  test.each(Object.entries(WAYS))('with %s turned is turned back', async (_, faces) => {
    const right = await volumeOf(write());
    expect(turnedIn(right)).toEqual([]);
    const content = written(write, faces);
    const found = await volumeOf(content);
    expect(found.volume).toBeCloseTo(right.volume, 4);
    expect(found.changes).toMatchObject([{ kind: 'orientation' }]);
    const left = await volumeOf(content, ['orientation']);
    if (faces.length === 6) expect(left.volume).toBeCloseTo(-right.volume, 4);
    expect(left.changes).toEqual([]);
  });
});

const CASE = '../shared/cases/28-inverted-faces';
test.skipIf(!existsSync(CASE))('the files of the case are read as the right ones are (../shared)', async () => {
  for (const extension of ['obj', 'stl']) {
    const [right, wrong] = await Promise.all(
      ['right', 'all-inverted'].map((name) => {
        const full = `${name}.${extension}`;
        return read([full, new Uint8Array(readFileSync(`${CASE}/${full}`))]);
      }),
    );
    expect(measure(wrong)).toEqual(measure(right));
    expect(measure(wrong).volume).toBeGreaterThan(0);
    expect(turnedIn(right)).toEqual([]);
    expect(turnedIn(wrong)).toHaveLength(1);
  }
});
