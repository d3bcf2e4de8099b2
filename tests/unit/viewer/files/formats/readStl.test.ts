import { describe, expect, test } from 'vitest';
import { asciiStl, boxStl, measure, read, refusal, triangles } from '../../../../../tools/modelFiles/modelWriters.js';

describe('STL', () => {
  test('normals that cannot be used are left to be computed', async () => {
    for (const normal of [
      [0, 0, 0],
      [NaN, 0, 1],
      [Infinity, 0, 0],
    ]) {
      const { mesh, notes } = await read(['box.stl', boxStl(normal)]);
      // Not NaN, with which a surface is drawn black. The library computes normals that are zero.
      expect(new Set(mesh.normals!)).toEqual(new Set([0]));
      expect(notes).toEqual([]);
    }
    const ascii = await read(['one.stl', asciiStl('nan -nan(ind) 1e400')]);
    expect([...ascii.mesh.normals!]).toEqual(new Array(9).fill(0));
  });

  test('binary files may begin with "solid" and go on after their triangles', async () => {
    const box = await read(['box.stl', boxStl([0, 0, 1], { header: 'solid facet', rest: 7 })]);
    expect(triangles(box)).toBe(12);
    expect(measure(box).volume).toBeCloseTo((2 / Math.sqrt(3)) ** 3, 4);
    expect(box.upAxis).toBe('z');
  });

  test('ASCII with comments, capitals, names, several solids, faces of four corners and any line ends', async () => {
    const quad = asciiStl('0 0 2', ['0 0 0', '1 0 0', '1 1 0', '0 1 0']);
    const next = asciiStl('0 0 2', ['1 0 0', '2 0 0', '2 1 0', '1 1 0']);
    const text = `# a comment: vertex 9 9 9\nsolid my normal vertex 1 2 3\n# another\n${quad.replace(/^.*\n/, '').toUpperCase()}${next}`;
    for (const end of ['\n', '\r\n', '\r']) {
      const both = await read(['two.stl', text.replaceAll('\n', end)]);
      expect(triangles(both)).toBe(4);
      expect(measure(both).area).toBeCloseTo(2 / 1.25);
      expect(both.mesh.normals!.slice(0, 3)).toEqual(Float32Array.of(0, 0, 1));
    }
  });

  test('ASCII faces keep their notches', async () => {
    const arrow = await read(['arrow.stl', asciiStl('0 0 1', ['-2 -1 0', '0 0 0', '2 -1 0', '0 1 0'])]);
    expect(triangles(arrow)).toBe(2);
    expect(measure(arrow).area).toBeCloseTo(2 / (2 ** 2 + 1 ** 2), 5);
  });

  test('numbers in every notation', async () => {
    const { mesh } = await read([
      'one.stl',
      asciiStl('0 0 1', ['+0 -0. .0', '1.0000000000000000000000001e2 0e5 0', '0 100.000 -0.0e-9']),
    ]);
    const side = Math.SQRT2;
    const expected = [-side / 2, -side / 2, 0, side / 2, -side / 2, 0, -side / 2, side / 2, 0];
    mesh.positions.forEach((value, i) => {
      expect(value).toBeCloseTo(expected[i], 6);
    });
  });

  test('a file of half a megabyte without an end is read in one pass', async () => {
    const text = `solid long\n${'facet normal 0 0 1 outer loop '.repeat(20_000)}`;
    expect(await refusal(['long.stl', text])).toMatch(/^The file holds no triangles/);
  });
});
