import { BoxGeometry } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import type { FileChangeKind } from '../../../../src/viewer/files/common/fileChanges.js';
import { type ReadMesh, readModel } from '../../../../src/viewer/files/readModel.js';
import { tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';
import { boxStl, type Content, file, triangles } from '../../../../tools/modelFiles/modelWriters.js';

async function read(name: string, content: Content, ...switched: FileChangeKind[]): Promise<ReadMesh> {
  const model = await readModel([file(name, content)], () => {}, undefined, { switched });
  if (model.kind !== 'mesh') throw new Error(`${name} is not a mesh`);
  return model;
}

const prim = (name: string, x: number, more = ''): string => `
    def Mesh "${name}"
    {
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        point3f[] points = [(${x}, 0, 0), (1, 0, 0), (1, 1, 0)]
        ${more}
    }`;
const usda = `#usda 1.0\n(\n    defaultPrim = "Root"\n)\n\ndef Xform "Root"\n{\n${[
  prim('seen', 0),
  prim('lamp', -1, 'token visibility = "invisible"'),
  prim('rig', -2, 'uniform token purpose = "guide"'),
].join('\n')}\n}\n`;

describe('changes to what a file says', () => {
  test('a model is stood up by the up axis of its format, unless that is left', async () => {
    const stl = boxStl([0, 0, 0]);
    const { upAxis, changes } = await read('a.stl', stl);
    expect([upAxis, changes]).toEqual(['z', [{ kind: 'up', sentence: 'stood up: z is up in STL files' }]]);
    const left = await read('a.stl', stl, 'up');
    expect([left.upAxis, left.stands, left.changes]).toEqual(['y', undefined, []]);
  });

  test('a model is stood on its flat side if that is clear, unless it is left', async () => {
    const rim = Array.from({ length: 12 }, (_, i) => (Math.PI * i) / 6);
    const cone = [
      'v 0 0 2',
      'v 0 0 0',
      ...rim.map((angle) => `v ${Math.cos(angle)} ${Math.sin(angle)} 0`),
      ...rim.flatMap((_, i) => [`f 1 ${i + 3} ${((i + 1) % 12) + 3}`, `f 2 ${((i + 1) % 12) + 3} ${i + 3}`]),
    ].join('\n');
    const { upAxis, changes } = await read('cone.obj', cone);
    expect([upAxis, changes]).toEqual(['z', [{ kind: 'up', sentence: 'stood on its flat side: z is up' }]]);
    const left = await read('cone.obj', cone, 'up');
    expect([left.upAxis, left.changes]).toEqual(['y', []]);
  });

  test('a model on feet is said to stand on them', async () => {
    const seat = mergeGeometries([
      new BoxGeometry(1, 1, 0.1),
      new BoxGeometry(1, 0.1, 1).translate(0, 0.45, 0.5),
      ...[-0.45, 0.45].flatMap((x) => [-0.45, 0.45].map((y) => new BoxGeometry(0.1, 0.1, 1).translate(x, y, -0.5))),
    ]).toNonIndexed();
    const { array } = seat.getAttribute('position');
    const lines = Array.from({ length: array.length / 3 }, (_, i) => `v ${array.slice(3 * i, 3 * i + 3).join(' ')}`);
    const faces = lines.flatMap((_, i) => (i % 3 === 0 ? [`f ${i + 1} ${i + 2} ${i + 3}`] : []));
    const { upAxis, changes } = await read('seat.obj', [...lines, ...faces].join('\n'));
    expect([upAxis, changes]).toEqual(['z', [{ kind: 'up', sentence: 'stood on its feet: z is up' }]]);
  });

  test('a model at map coordinates stands by its heights, unless that is left', async () => {
    const at = (...origin: number[]): string =>
      [
        ...[0, 1, 2, 3].map(
          (i) => `v ${[3 * (i % 2), i > 1 ? 5 : 0, i === 3 ? 1 : 0].map((x, k) => x + origin[k]).join(' ')}`,
        ),
        'f 1 2 3',
        'f 2 4 3',
      ].join('\n');
    const { upAxis, changes } = await read('plot.obj', at(432_000, 5_123_000, 115));
    expect([upAxis, changes]).toEqual(['z', [{ kind: 'up', sentence: 'stood up as on maps: z is up' }]]);
    for (const [content, ...switched] of [
      [at(432_000, 5_123_000, 115), 'up'],
      [at(432_000, 115, -5_123_000)],
      [at(0, 0, 5_123_000)],
      [at(432_000, 5_123_000, 300_000)],
    ] as [string, ...FileChangeKind[]][]) {
      const left = await read('plot.obj', content, ...switched);
      expect([left.upAxis, left.changes]).toEqual(['y', []]);
    }
  });

  test('nodes that a glTF file hides are left out, and counted, or shown', async () => {
    const builder = tetrahedron();
    const hidden = { extensions: { KHR_node_visibility: { visible: false } }, children: [2] };
    const nodes = [{ mesh: 0 }, hidden, { mesh: 0, translation: [3, 0, 0] }];
    Object.assign(builder.json, { nodes, scenes: [{ nodes: [0, 1] }] });
    const glb = builder.glb();
    const whole = await read('a.glb', glb);
    expect([triangles(whole), whole.changes]).toEqual([
      4,
      [{ kind: 'hidden', sentence: '1 part left out: hidden in the file' }],
    ]);
    const shown = await read('a.glb', glb, 'hidden');
    expect([triangles(shown), shown.changes]).toEqual([8, []]);
  });

  test('invisible prims of a USD file are shown on request, but not its guides', async () => {
    const whole = await read('a.usda', usda);
    expect([triangles(whole), whole.changes.map(({ kind }) => kind)]).toEqual([1, ['hidden']]);
    const shown = await read('a.usda', usda, 'hidden');
    expect([triangles(shown), shown.changes]).toEqual([2, []]);
  });
});
