import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial } from 'three';
import { describe, expect, test } from 'vitest';
import { ModelError, shownText, toModelError } from '../../../../src/viewer/files/common/ModelError.js';
import { cleanMesh } from '../../../../src/viewer/files/mesh/cleanMesh.js';
import { fitModel } from '../../../../src/viewer/files/mesh/fitModel.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { mergeScene } from '../../../../src/viewer/files/scenes/mergeScene.js';

describe('the sentence of an error', () => {
  test('includes a loader’s message, without the loader’s name', () => {
    expect(toModelError('a.fbx', new Error('THREE.FBXLoader: Unknown format.')).message).toBe(
      'a.fbx could not be read; it seems to be damaged (Unknown format).',
    );
    const own = new ModelError('a.ply holds no points.');
    expect(toModelError('a.ply', own)).toBe(own);
  });

  test.each([
    () => (undefined as unknown as { x: object }).x,
    () => (null as unknown as () => void)(),
    () => JSON.parse('{'),
    () => new DataView(new ArrayBuffer(2)).getUint32(0),
    () => decodeURIComponent('%'),
    () => {
      throw new DOMException('The source image could not be decoded.');
    },
    () => {
      throw undefined;
    },
  ])('says nothing that JavaScript says: %s', (fail) => {
    let thrown: unknown;
    try {
      fail();
    } catch (error) {
      thrown = error;
    }
    expect(toModelError('a.glb', thrown, 'its mesh').message).toBe(
      'a.glb could not be read; its mesh seems to be damaged.',
    );
  });

  test('blames no file for a worker that died', () => {
    const death = new Error('The hatching worker died (out of memory) before this request was finished. Ask again.');
    expect(toModelError('Bunny', death, 'its mesh').message).toBe(
      'Bunny was not prepared to the end: the browser has ended the worker that did it, most often for want of memory. Open it again, or a smaller one.',
    );
  });

  test('tells memory that is gone', () => {
    expect(toModelError('a.glb', new RangeError('Array buffer allocation failed')).message).toBe(
      'a.glb needs more memory than this page can get, or it is damaged.',
    );
  });
});

describe('names from files cannot disguise a message', () => {
  const hostile = `start\u202e${'from trusted.test '.repeat(60)}\n\u0007end`;
  const shown = /start[^\p{Cc}\p{Cf}]{1,30}…[^\p{Cc}\p{Cf}]{1,30}end/u;
  const gltf = (rest: object) => JSON.stringify({ asset: { version: '2.0' }, ...rest });
  const drawn = {
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ componentType: 5126, count: 3, type: 'VEC3' }],
  };

  test.each([
    ['.glb', 'no model'],
    ['.ply', 'ply\nformat ascii 1.0\nend_header\n'],
    ['.zip', 'PK\u0003\u0004'],
    ['.fbx', '; FBX\nFBXHeaderExtension: {'],
    ['.dae', '<COLLADA></COLLADA>'],
    ['.stl.gz', '\u001f\u008b\u0008'],
    ['.xyz', ''],
  ])('the dropped file: *%s', async (extension, content) => {
    const bytes = Uint8Array.from(content, (character) => character.charCodeAt(0));
    const file = { name: hostile + extension, content: new Blob([bytes]) };
    const stages: string[] = [];
    const error: Error = await readModel([file], (stage) => void stages.push(stage)).catch((thrown) => thrown);
    expect(error).toBeInstanceOf(ModelError);
    for (const said of [error.message, stages[0]]) expect(said).toMatch(shown);
  });

  test.each([
    ['a file beside it', gltf({ ...drawn, buffers: [{ uri: `${hostile}.bin`, byteLength: 4 }] })],
    ['an extension', gltf({ ...drawn, extensionsRequired: [hostile] })],
  ])('%s', async (_, content) => {
    const file = { name: 'a.gltf', content: new Blob([content]) };
    const error: Error = await readModel([file], () => {}).catch((thrown) => thrown);
    expect(error.message).toMatch(shown);
  });

  test('the files that an OBJ asks for', async () => {
    const obj = `mtllib ${hostile.replaceAll(/\s/g, '_')}.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n`;
    const read = await readModel([{ name: 'a.obj', content: new Blob([obj]) }], () => {});
    expect(read.notes.join()).toMatch(shown);
    // They are looked for by the names that they have.
    expect(read.missing[0]).toContain('\u202e');
  });

  test('any of a loader', () => {
    const { message } = toModelError(hostile, new Error(`Unknown ${hostile}.`));
    expect(shownText(message)).toMatch(/^start.*…end could not be read.*\.$|^start.*could not be read; it seems/);
    expect(shownText(message)).not.toMatch(/[\p{Cc}\p{Cf}]/u);
  });
});

describe('models of any size', () => {
  /** A box at the origin and an instance of it five sizes away, as they are drawn. */
  function fitted(size: number, distance = 5 * size): Float32Array {
    const boxes = new InstancedMesh(new BoxGeometry(size, size, size), new MeshBasicMaterial(), 2);
    boxes.setMatrixAt(1, new Matrix4().makeTranslation(distance, 0, 0));
    const { mesh } = cleanMesh(mergeScene(new Group().add(boxes)));
    fitModel(mesh);
    return mesh.positions;
  }

  test('a tiny mesh that instances spread is not a point', () => {
    const usual = fitted(1);
    for (const size of [1e-12, 1e-40]) {
      fitted(size).forEach((value, i) => {
        expect(value).toBeCloseTo(usual[i], 4);
      });
    }
    const root = new Group().add(new Mesh(new BoxGeometry(1, 1, 1)));
    root.scale.setScalar(1e-60);
    const { mesh } = cleanMesh(mergeScene(root));
    fitModel(mesh);
    expect(Math.max(...mesh.positions)).toBeCloseTo(1 / Math.sqrt(3), 5);
  });

  test('a part far from the origin keeps its form', () => {
    const box = new Mesh(new BoxGeometry(1, 1, 1));
    box.position.set(5e9, -3e9, 0);
    const { mesh } = cleanMesh(mergeScene(new Group().add(box)));
    fitModel(mesh);
    expect(new Set(mesh.positions.map((value) => Math.round(1e4 * Math.abs(value))))).toEqual(new Set([5774]));
  });

  test('a part without size is refused', () => {
    const point = new Mesh(new BoxGeometry(0, 0, 0));
    expect(() => fitModel(cleanMesh(mergeScene(new Group().add(point))).mesh)).toThrow('lie at one place');
  });
});
