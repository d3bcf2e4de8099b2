import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial } from 'three';
import { describe, expect, test } from 'vitest';
import { cleanMesh } from '../../../../src/demo/files/cleanMesh.js';
import { fitModel } from '../../../../src/demo/files/fitModel.js';
import { ModelError, toModelError } from '../../../../src/demo/files/ModelError.js';
import { mergeScene } from '../../../../src/demo/files/mergeScene.js';

describe('the sentence of an error', () => {
  test('passes on what a loader says, without its name', () => {
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

describe('models of any size', () => {
  /** A box at the origin and an instance of it five sizes away, as they are drawn. */
  function fitted(size: number, distance = 5 * size): Float32Array {
    const boxes = new InstancedMesh(new BoxGeometry(size, size, size), new MeshBasicMaterial(), 2);
    boxes.setMatrixAt(1, new Matrix4().makeTranslation(distance, 0, 0));
    const { mesh } = cleanMesh(mergeScene(new Group().add(boxes)));
    fitModel(mesh);
    return mesh.positions;
  }

  test('a tiny part that instances spread is no point', () => {
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
