import { describe, expect, test } from 'vitest';
import { type ReadMesh, readModel } from '../../../../src/viewer/files/readModel.js';
import { colouredBoxObj, measure, read } from '../../../../tools/modelFiles/modelWriters.js';

describe('what the caption says', () => {
  const box = colouredBoxObj.replace('mtllib box.mtl\n', '');

  test('models that were dropped together are counted, and there is a way to see the others', async () => {
    expect((await read(['a.obj', box], ['wood.png', ''], ['notes.txt', ''])).notes).toEqual([]);
    const two = await read(['b.ply', 'ply'], ['a.obj', box]);
    expect([two.name, two.notes]).toEqual(['a.obj', ['one of 2 models: drop b.ply by itself to see it']]);
    const three = await read(['b.ply', 'ply'], ['a.obj', box], ['b.obj', box]);
    expect([three.name, three.notes]).toEqual(['a.obj', ['one of 3 models: drop another by itself to see it']]);
  });

  test('missing files come first in the notes, and all their names are listed', async () => {
    const faces = box.slice(box.indexOf('usemtl'));
    const libraries = ['a', 'b', 'c'].map((name) => `mtllib ${name}.mtl`);
    const { notes, details } = await read(
      ['a.obj', [...libraries, box, faces.replace(/^f /m, 'f 99 ')].join('\n')],
      ['b.obj', box],
    );
    expect(notes).toEqual([
      'a.mtl, b.mtl and 1 more are missing: drop them along',
      'one of 2 models: drop b.obj by itself to see it',
    ]);
    expect(details[0]).toBe('missing: a.mtl, b.mtl, c.mtl');
    expect(details.slice(1)).toEqual([
      expect.stringMatching(/without three valid corners left out$/),
      expect.stringMatching(/duplicate triangles left out$/),
    ]);
  });

  test('each step on the triangles of a file is reported', async () => {
    const stages: string[] = [];
    await readModel([{ name: 'a.obj', content: new Blob([box]) }], (stage) => void stages.push(stage));
    expect(stages).toEqual([
      'reading a.obj',
      'reading a.obj',
      'looking over the triangles',
      'looking for triangles that face inward',
      'looking for the ground',
    ]);
  });

  test.each([
    ['slivers', 1e-5, 2, true],
    ['thin strips that can be seen', 1e-2, 2, false],
    ['dust', 1e-4, 1e-4, true],
  ])('%s: whether triangles are too thin to be hatched', async (_, height, width, isThin) => {
    const triangles = Array.from({ length: 20 }, (_, i) => {
      const [x, y] = [Math.cos(i), i / 10];
      return `v ${x} ${y} 0\nv ${x + width} ${y} 0\nv ${x} ${y + height} 0\nf -3 -2 -1`;
    });
    const { notes } = await read(['a.obj', triangles.join('\n')]);
    expect(notes).toEqual(isThin ? ['its triangles are too thin to be hatched'] : []);
  });
});

describe('normals of a file', () => {
  const box = colouredBoxObj.replace('mtllib box.mtl\n', '');
  /** The box with one normal at all corners. */
  const withNormal = (normal: string): string =>
    `vn ${normal}\n${box.replace(/^f (.*)$/gm, (_, rest: string) => `f ${rest.replace(/(\d+)(?:\/\S*)?/g, '$1//1')}`)}`;

  test('are computed again where they contradict the surface, which is said behind "i"', async () => {
    const { mesh, changes } = (await read(['a.obj', withNormal('0 0 1')])) as ReadMesh;
    expect(mesh.normals).toBeNull();
    expect(changes).toEqual([{ kind: 'orientation', sentence: 'normals that contradict its surfaces computed again' }]);
  });

  test('are kept where they lean less, or if that is asked for', async () => {
    const { mesh, changes } = (await read(['a.obj', withNormal('1 1 1')])) as ReadMesh;
    expect(mesh.normals![0]).toBeCloseTo(3 ** -0.5, 6);
    expect(changes).toEqual([]);
    const file = { name: 'a.obj', content: new Blob([withNormal('0 0 1')]) };
    const asWritten = await readModel([file], () => {}, undefined, { switched: ['orientation'] });
    expect([...(asWritten as ReadMesh).mesh.normals!.slice(0, 3)]).toEqual([0, 0, 1]);
  });
});

describe('what faces inward', () => {
  const inward = colouredBoxObj
    .replace('mtllib box.mtl\n', '')
    .replace(/^f (\S+) (.*)$/gm, (_, first: string, rest: string) =>
      ['f', first, ...rest.split(' ').reverse()].join(' '),
    );

  test('is turned in formats that promise nothing, and said behind "i"', async () => {
    const right = await read(['a.obj', colouredBoxObj.replace('mtllib box.mtl\n', '')]);
    const { changes, ...found } = await read(['a.obj', inward]);
    expect(measure(found as typeof right).volume).toBeCloseTo(measure(right).volume, 6);
    expect(measure(right).volume).toBeGreaterThan(0);
    const sentence = '12 triangles that faced inward turned around';
    expect(changes).toEqual([{ kind: 'orientation', sentence }]);
    expect(right.changes).toEqual([]);
  });

  test('is left as written if that is asked for', async () => {
    const file = { name: 'a.obj', content: new Blob([inward]) };
    const found = await readModel([file], () => {}, undefined, { switched: ['orientation'] });
    expect(measure(found as Awaited<ReturnType<typeof read>>).volume).toBeLessThan(0);
    expect(found.changes).toEqual([]);
  });
});
