import type { Mesh } from 'three';
import { describe, expect, test } from 'vitest';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../../../src/viewer/drawing/HatchedModel.js';
import { withoutParts } from '../../../../src/viewer/drawing/ModelParts.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { castersOf } from '../../../../src/viewer/sceneSetup/groundShadow.js';
import { addTrack, tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';
import { type Content, file, read } from '../../../../tools/modelFiles/modelWriters.js';

const { signal } = new AbortController();

async function build(name: string, content: Content, ...hidden: string[]): Promise<HatchedModel> {
  const model = await readModel([file(name, content)], () => {});
  const choose = (names: readonly string[]): number[] => hidden.map((one) => names.indexOf(one));
  return (await buildModel(model, () => {}, signal, false, choose)).model;
}

/** Two tetrahedra side by side, the second of which may move. */
function pair(moves: boolean): Uint8Array {
  const builder = tetrahedron();
  Object.assign(builder.json, {
    nodes: [
      { name: 'Left', mesh: 0, children: [1] },
      { name: 'Right', mesh: 0, translation: [4, 0, 0] },
    ],
  });
  if (moves) {
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 0, 0.1, 0), 'VEC3'));
  }
  return builder.glb();
}

const trianglesIn = (mesh: Mesh): number => {
  const { index, attributes } = mesh.geometry;
  return (index?.count ?? attributes.hatchNormal.count) / 3;
};

describe('hidden parts of a joined mesh', () => {
  test('are not built, and the rest stays where it is and as it is framed', async () => {
    const whole = await build('a.glb', pair(false));
    const half = await build('a.glb', pair(false), 'Right');
    expect(whole.parts?.names).toEqual(['Left', 'Right']);
    expect(half.parts?.hidden).toEqual([1]);
    expect([whole, half].map(({ root }) => meshesOf(root).map(trianglesIn))).toEqual([[8], [4]]);
    expect(half.bounds).toEqual(whole.bounds);
    expect(half.framedPoints).toEqual(whole.framedPoints);
    const [{ geometry }] = meshesOf(half.root);
    geometry.computeBoundingBox();
    expect(geometry.boundingBox!.max.x).toBeLessThan(0);
    expect(half.parts?.trianglesOf(1, 100)).toHaveLength(4 * 9);
  });

  test('leave nothing to draw if they are all hidden, which is no fault', async () => {
    const none = await build('a.glb', pair(false), 'Left', 'Right');
    expect(meshesOf(none.root)).toEqual([]);
    expect(none.parts?.hidden).toEqual([0, 1]);
  });

  test('are taken out of the ranges of pictures and glass', async () => {
    const triangle = (x: number): string => `v ${x} 0 0\nv ${x + 1} 0 0\nv ${x} 1 ${x}\nf -3 -2 -1\n`;
    const obj = `mtllib a.mtl\no A\nusemtl solid\n${triangle(0)}usemtl glass\n${triangle(2)}o B\n${triangle(4)}o C\nusemtl solid\n${triangle(6)}`;
    const { mesh } = await read(['a.obj', obj], ['a.mtl', 'newmtl solid\nKd 1 1 1\nnewmtl glass\nd 0.3\n']);
    expect(mesh.ranges?.map(({ count }) => count)).toEqual([6, 6]);
    const less = withoutParts(mesh, [0]);
    expect(less.ranges?.map(({ start, count, isSeeThrough = false }) => [start, count, isSeeThrough])).toEqual([
      [0, 3, false],
      [3, 3, true],
    ]);
    expect([...less.parts!.ofVertices]).toEqual([2, 2, 2, 1, 1, 1].sort());
    expect(withoutParts(mesh, [])).toBe(mesh);
  });
});

describe('hidden parts of a scene', () => {
  test('are on no layer, and their children stay', async () => {
    const model = await build('a.glb', pair(true), 'Left');
    const [left, right] = meshesOf(model.root);
    expect([left.layers.mask, right.layers.mask]).toEqual([0, 1]);
    const casting = castersOf(model.root).length;
    model.parts?.hide?.([]);
    expect([left.layers.mask, right.layers.mask]).toEqual([1, 1]);
    expect(castersOf(model.root).length).toBeGreaterThan(casting);
    expect(model.parts?.trianglesOf(0, 1000)).toHaveLength(4 * 9);
  });
});
