import { describe, expect, test } from 'vitest';
import { BOX_CORNERS, BOX_FACES } from '../../../tools/modelFiles/box.js';
import { CORNER_LIST, colorsOf, ply, read, refusal, triangles, XYZ } from '../../../tools/modelFiles/modelWriters.js';

/** A box within a box: both in one mesh, whose outer faces have an alpha. */
const POINTS = [...BOX_CORNERS, ...BOX_CORNERS.map((corner) => corner.map((value) => 3 * value - 1))];
const FACES = [...BOX_FACES, ...BOX_FACES.map((face) => face.map((corner) => corner + 8))];
const isOuter = (corner: number): boolean => corner >= 8;

/** A file in which the outer box has an alpha. */
type Writer = (alpha: number) => [name: string, content: string | Uint8Array];

const RGBA = ['red', 'green', 'blue', 'alpha'];
const rgba = (outer: boolean, alpha: number): number[] => (outer ? [0, 0, 255, alpha] : [255, 255, 255, 255]);

const plyOfVertices =
  (format: 'ascii' | 'binary_little_endian', type: string): Writer =>
  (alpha) => {
    const properties = [...XYZ, ...RGBA.map((name) => `${type} ${name}`)];
    const full = type === 'uchar' ? 1 : 255;
    const rows = POINTS.map((point, i) => [...point, ...rgba(isOuter(i), alpha).map((value) => value / full)]);
    const faces = { name: 'face', properties: [CORNER_LIST], rows: FACES.map((face) => [face]) };
    return ['box.ply', ply([{ name: 'vertex', properties, rows }, faces], format)];
  };
const plyOfFaces: Writer = (alpha) => {
  const properties = [CORNER_LIST, ...RGBA.map((name) => `uchar ${name}`)];
  const rows = FACES.map((face) => [face, ...rgba(isOuter(face[0]), alpha)]);
  return [
    'box.ply',
    ply([
      { name: 'vertex', properties: XYZ, rows: POINTS },
      { name: 'face', properties, rows },
    ]),
  ];
};
const off =
  (keyword: string, isOfVertices: boolean, full: number): Writer =>
  (alpha) => {
    const colour = (outer: boolean): string =>
      rgba(outer, alpha)
        .map((value) => ` ${value / full}`)
        .join('');
    const vertices = POINTS.map((point, i) => point.join(' ') + (isOfVertices ? colour(isOuter(i)) : ''));
    const faces = FACES.map((face) => `4 ${face.join(' ')}${isOfVertices ? '' : colour(isOuter(face[0]))}`);
    return ['box.off', [keyword, `${POINTS.length} ${FACES.length} 0`, ...vertices, ...faces, ''].join('\n')];
  };

describe.each<[string, Writer]>([
  ['PLY, vertices', plyOfVertices('ascii', 'uchar')],
  ['PLY, vertices, binary', plyOfVertices('binary_little_endian', 'uchar')],
  ['PLY, vertices, fractions', plyOfVertices('binary_little_endian', 'float')],
  ['PLY, faces', plyOfFaces],
  ['OFF, vertices', off('COFF', true, 1)],
  ['OFF, vertices, fractions', off('COFF', true, 255)],
  ['OFF, faces', off('OFF', false, 1)],
])('%s with an alpha', (_, write) => {
  test('are seen through, hide what they are round, or are not there', async () => {
    const glass = await read(write(64));
    expect(triangles(glass)).toBe(24);
    expect(glass.mesh.ranges).toEqual([
      { start: 0, count: 36, picture: -1 },
      { start: 36, count: 36, picture: -1, isSeeThrough: true },
    ]);
    expect(colorsOf(glass).slice(12)).toEqual(Array(12).fill('0,0,255'));
    const solid = await read(write(255));
    expect([triangles(solid), solid.mesh.ranges]).toEqual([24, undefined]);
    const clear = await read(write(0));
    expect([triangles(clear), clear.mesh.ranges, colorsOf(clear)]).toEqual([
      12,
      undefined,
      Array(12).fill('255,255,255'),
    ]);
  });
});

test('an alpha by which nothing would be seen does not count', async () => {
  const rows = BOX_FACES.map((face) => [face, 255, 0, 0, 0]);
  const properties = [CORNER_LIST, ...RGBA.map((name) => `uchar ${name}`)];
  const tables = [
    { name: 'vertex', properties: XYZ, rows: BOX_CORNERS },
    { name: 'face', properties, rows },
  ];
  const box = await read(['box.ply', ply(tables)]);
  expect([triangles(box), box.mesh.ranges]).toEqual([12, undefined]);
});

test('lines and pictures that are not drawn are said', async () => {
  const tables = [
    { name: 'vertex', properties: XYZ, rows: BOX_CORNERS },
    { name: 'face', properties: [CORNER_LIST], rows: BOX_FACES.map((face) => [face]) },
    { name: 'edge', properties: ['int vertex1', 'int vertex2'], rows: [[0, 7]] },
  ];
  expect((await read(['box.ply', ply(tables)])).notes).toEqual(['points and lines left out']);
  expect((await read(['box.ply', ply(tables.slice(0, 2))])).notes).toEqual([]);
  const pictured = String.fromCharCode(...ply(tables.slice(0, 2))).replace(
    'element',
    'comment TextureFile a b.png\nelement',
  );
  expect((await read(['box.ply', pictured])).notes).toEqual(['without a b.png: pictures on PLY are not read']);
  const [name, text] = off('OFF', false, 1)(255);
  const withLine = `${String(text).replace(' 12 0\n', ' 13 0\n')}2 0 7\n`;
  expect((await read([name, withLine])).notes).toEqual(['points and lines left out']);
  expect(await refusal([name, 'OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n'])).toMatch(/^The file holds no triangles/);
});
