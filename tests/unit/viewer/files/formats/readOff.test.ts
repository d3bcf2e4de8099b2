import { describe, expect, test } from 'vitest';
import {
  colorsOf,
  measure,
  PRISM_CORNERS,
  PRISM_FACES,
  read,
  refusal,
  triangles,
} from '../../../../../tools/modelFiles/modelWriters.js';

const counts = `${PRISM_CORNERS.length} ${PRISM_FACES.length} 18`;
const rows = (after = (_corner: number): string => ''): string[] =>
  PRISM_CORNERS.map((corner, i) => corner.join(' ') + after(i));
const faces = (after = (_face: number): string => ''): string[] =>
  PRISM_FACES.map((face, i) => `${face.length} ${face.join(' ')}${after(i)}`);
const off = (...lines: string[]): [string, string] => ['prism.off', lines.join('\n')];
/** The volume of a prism over a hexagon of radius 1 and height 1, fitted to a radius of 1. */
const VOLUME = ((3 * Math.sqrt(3)) / 2) * (1 / Math.hypot(1, 0.5)) ** 3;

describe('OFF', () => {
  const headers: [string, string[]][] = [
    ['the usual header', ['OFF', counts]],
    ['counts in the first line', [`OFF ${counts}`]],
    ['counts at the first word, as in ModelNet', [`OFF${counts}`]],
    ['no first word', [counts]],
    ['no number of edges, and comments', ['# a prism', 'OFF # text', '', '# 12 8', '12 8 # no edges']],
    ['carriage returns', ['OFF\r', `${counts}\r`]],
  ];
  test.each(headers)('faces with any number of corners, %s', async (_, header) => {
    const prism = await read(off(...header, ...rows(), '# faces', ...faces(), ''));
    expect(triangles(prism)).toBe(2 * 4 + 6 * 2);
    expect(measure(prism).volume).toBeCloseTo(VOLUME, 5);
    expect([prism.upAxis, prism.mesh.normals, prism.mesh.colors, prism.notes]).toEqual(['y', null, null, []]);
  });

  test('it is known by its content, too', async () => {
    const [, text] = off('OFF', counts, ...rows(), ...faces());
    expect(triangles(await read(['prism.obj', text]))).toBe(20);
  });

  test.each([
    ['COFF', ' 255 0 0 255'],
    ['COFF', ' 1 0 0'],
    ['OFF', ' 1.0 0.0 0.0 1.0 # red'],
  ])('colours of vertices, %s with "%s"', async (keyword, colour) => {
    const prism = await read(off(keyword, counts, ...rows((i) => (i < 6 ? colour : '')), ...faces()));
    expect(new Set(colorsOf(prism))).toEqual(new Set(['255,0,0', '255,255,255']));
  });

  test.each([[' 255 0 0'], [' 1.0 0.0 0.0 1.0']])(
    'colours of faces, "%s", before those of vertices',
    async (colour) => {
      const text = off('COFF', counts, ...rows(() => ' 0 0 255 255'), ...faces((i) => (i === 0 ? colour : ' 7')));
      const colours = colorsOf(await read(text));
      expect(colours.slice(0, 4)).toEqual(new Array(4).fill('255,0,0'));
      expect(new Set(colours.slice(4))).toEqual(new Set(['255,255,255']));
    },
  );

  test('faces keep their notches', async () => {
    const arrow = await read(off('OFF', '4 1 4', '-2 -1 0', '0 0 0', '2 -1 0', '0 1 0', '4 0 1 2 3'));
    const [width, height] = [4, 2];
    const scale = 1 / Math.hypot(width / 2, height / 2);
    expect(triangles(arrow)).toBe(2);
    expect(measure(arrow).area).toBeCloseTo(2 * scale ** 2, 5);
  });

  test('normals, a fourth coordinate and texture coordinates', async () => {
    // Between those of the three faces at a corner: normals that contradict their faces are left out.
    const outward = ([x, y, z]: readonly number[]) => [x, y, Math.sign(z - 0.5)];
    const normal = await read(
      off('NOFF', counts, ...rows((i) => ` ${outward(PRISM_CORNERS[i]).join(' ')}`), ...faces()),
    );
    const [x, y, z] = outward(PRISM_CORNERS[0]).map((value) => value / Math.SQRT2);
    expect(normal.mesh.normals![0]).toBeCloseTo(x, 6);
    expect(normal.mesh.normals![1]).toBeCloseTo(y, 6);
    expect(normal.mesh.normals![2]).toBeCloseTo(z, 6);
    const divided = PRISM_CORNERS.map((corner) => `${corner.map((value) => 2 * value).join(' ')} 2`);
    expect(measure(await read(off('4OFF', counts, ...divided, ...faces()))).volume).toBeCloseTo(VOLUME, 5);
    const textured = await read(off('STOFF', counts, ...rows(() => ' 0.5 0.5'), ...faces()));
    expect([triangles(textured), textured.mesh.colors]).toEqual([20, null]);
  });

  test('what cannot be read is said', async () => {
    const whole = off('OFF', counts, ...rows(), ...faces())[1];
    for (const text of [whole.slice(0, 60), whole.slice(0, whole.length / 2), whole.slice(0, -30)])
      expect(await refusal(['a.off', text])).toMatch(/^a\.off is cut short/);
    expect(await refusal(['a.off', 'OFF BINARY\n\0\0\0\x08'])).toBe(
      'a.off is a binary OFF file, which this page does not read; save it as text, or as PLY.',
    );
    expect(await refusal(['a.off', 'OFF\nmany faces'])).toBe(
      'a.off is damaged: it does not say how many points and faces it holds.',
    );
    expect(await refusal(['a.off', '4nOFF\n5\n1 1 0\n0 0 0 0 0 1'])).toMatch(
      /^a\.off has points with other than three coordinates/,
    );
    expect(await refusal(['a.off', 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n'])).toMatch(/^The file holds no triangles/);
  });
});
