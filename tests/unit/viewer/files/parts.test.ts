import { describe, expect, test } from 'vitest';
import { partNames } from '../../../../src/viewer/files/common/partNames.js';
import type { PlainMesh } from '../../../../src/viewer/files/mesh/PlainMesh.js';
import { tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';
import { read } from '../../../../tools/modelFiles/modelWriters.js';

describe('names of parts', () => {
  test.each([
    [
      ['Body', 'Door'],
      ['Body', 'Door'],
    ],
    [
      [' Body ', '', 'Wheel', 'Wheel', 'Wheel'],
      ['Body', 'Part 2', 'Wheel', 'Wheel 2', 'Wheel 3'],
    ],
    [
      ['Wheel', 'Wheel 2', 'Wheel'],
      ['Wheel', 'Wheel 2', 'Wheel 3'],
    ],
    [
      ['', 'Part 1'],
      ['Part 1', 'Part 1 2'],
    ],
  ])('%j become %j', (names, unique) => {
    expect(partNames(names)).toEqual(unique);
  });

  test('thousands of equal names are numbered at once', () => {
    expect(new Set(partNames(Array.from({ length: 20_000 }, () => 'Stone'))).size).toBe(20_000);
  });
});

/** The number of triangles of each part, by name. */
function countsOf({ parts, indices }: PlainMesh): Record<string, number> {
  const counts: Record<string, number> = {};
  for (let corner = 0; corner < indices!.length; corner += 3) {
    const [part, ...others] = [0, 1, 2].map((k) => parts!.ofVertices[indices![corner + k]]);
    expect(others).toEqual([part, part]);
    counts[parts!.names[part]] = (counts[parts!.names[part]] ?? 0) + 1;
  }
  return counts;
}

/** Faces of an OBJ file, each of its own corners. */
function obj(...lines: (string | number)[]): string {
  let x = 0;
  return lines
    .map((line) => {
      if (typeof line === 'string') return line;
      const corners = Array.from({ length: line }, (_, i) => {
        const angle = (2 * Math.PI * i) / line;
        return `v ${x + Math.cos(angle)} ${Math.sin(angle)} ${i % 2}`;
      });
      x += 3;
      return `${corners.join('\n')}\nf ${corners.map((_, i) => i - line).join(' ')}`;
    })
    .join('\n');
}

describe('parts of a file', () => {
  test('objects and groups of an OBJ file, whichever faces they have', async () => {
    const text = obj(
      ...['# o not an object', 'o Chair', 'usemtl wood', 3, 4, 'g Chair_Seat', 'usemtl cloth', 5],
      ...['o Table', 'g default', 3, 'g Leg', 6, 'g default', 3, 'o Chair', 3],
    );
    const { mesh } = await read(['a.obj', text]);
    expect(countsOf(mesh)).toEqual({ Chair: 3, Chair_Seat: 3, Table: 2, 'Table: Leg': 4, 'Chair 2': 1 });
  });

  test('materials of an OBJ file of one object', async () => {
    const { mesh } = await read(['a.obj', obj('o House', 'usemtl brick', 3, 'usemtl glass', 4, 'usemtl brick', 3)]);
    expect(countsOf(mesh)).toEqual({ brick: 2, glass: 2 });
  });

  test('a file of one part lists none', async () => {
    expect((await read(['a.obj', obj('o Stone', 3, 4)])).mesh.parts).toBeUndefined();
  });

  test('nodes of a glTF file, by their own names or those of their groups', async () => {
    const builder = tetrahedron();
    const nodes = [
      { name: 'Scene', children: [1, 2, 5] },
      { name: 'Lid', mesh: 0 },
      { name: 'Hinge', children: [3, 4], translation: [3, 0, 0] },
      { name: 'Object_7', mesh: 0 },
      { name: 'Object_8', mesh: 0, translation: [0, 3, 0] },
      { mesh: 0, translation: [0, 0, 5] },
    ];
    Object.assign(builder.json, { nodes });
    const { mesh } = await read(['a.glb', builder.glb()]);
    expect(countsOf(mesh)).toEqual({ Lid: 4, Hinge: 4, 'Hinge 2': 4, 'Part 4': 4 });
  });

  test('parts stay with their triangles when others are turned, broken or left out', async () => {
    const turned = obj('o First', 3, 3, 'o Second', 4, 'f 99 98 97', 'o Third', 5).replace(
      'o Third',
      'f 1 1 2\no Third',
    );
    const { mesh } = await read(['a.obj', turned]);
    expect(countsOf(mesh)).toMatchObject({ First: 2, Third: 3 });
  });
});
