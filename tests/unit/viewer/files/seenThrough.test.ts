import { PNG } from 'pngjs';
import { describe, expect, test } from 'vitest';
import { NodeSurroundings } from '../../../../src/command/draw/NodeSurroundings.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { BOX_CORNERS, BOX_FACES } from '../../../../tools/modelFiles/box.js';
import {
  CORNER_LIST,
  colorsOf,
  colouredBoxObj,
  file,
  ply,
  read,
  refusal,
  triangles,
  XYZ,
} from '../../../../tools/modelFiles/modelWriters.js';
import { dae, wrl } from '../../../../tools/modelFiles/sceneWriters.js';

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
  test('are see-through, opaque or invisible', async () => {
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

/** A picture of one colour, or one whose left half has another. */
function picture(right: number[], left = right): Uint8Array {
  const png = new PNG({ width: 8, height: 8 });
  for (let i = 0; i < 64; i++) png.data.set(i % 8 < 4 ? left : right, 4 * i);
  return PNG.sync.write(png);
}

const GREY = picture([110, 110, 110, 255]);
const HALF_CLEAR = picture([110, 110, 110, 110]);
const STRIPES = picture([255, 255, 255, 255], [0, 0, 0, 0]);
const WHITE = picture([255, 255, 255, 255]);

/** A square with a picture, beside a box without one. */
const obj = (mtl: string, content: Uint8Array): Record<string, string | Uint8Array> => ({
  'a.obj': `mtllib a.mtl\n${colouredBoxObj.replace(/^(mtllib|usemtl).*$/gm, '')}
v 3 0 0\nv 4 0 0\nv 4 1 0\nv 3 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl pane\nf 9/1 10/2 11/3 12/4\n`,
  'a.mtl': `newmtl pane\n${mtl}\n`,
  'p.png': content,
});
/** A box, whose red sides have the picture as their transparency. */
const collada = (opaque: string, isColoured: boolean, content: Uint8Array): Record<string, string | Uint8Array> => {
  const transparent = `<transparent opaque="${opaque}"><texture texture="sampler" texcoord="UV"/></transparent>`;
  const text = dae('p.png').replace('</diffuse>', `</diffuse>${transparent}`);
  const colour = '<diffuse><color>1 0 0 1</color></diffuse>';
  return { 'a.dae': isColoured ? text.replace(/<diffuse><texture.*?<\/diffuse>/, colour) : text, 'p.png': content };
};

test.each<[string, Record<string, string | Uint8Array>, string]>([
  ['map_d of grey', obj('map_d p.png', GREY), 'glass'],
  ['map_d of white', obj('map_d p.png', WHITE), 'opaque'],
  ['map_d of stripes', obj('map_d p.png', STRIPES), 'cut out'],
  ['one picture that is half clear', obj('map_Kd p.png\nmap_d p.png', HALF_CLEAR), 'glass'],
  ['colours and an alpha', obj('map_Kd p.png\nmap_d -clamp on p.png', STRIPES), 'cut out'],
  ['A_ONE, half clear', collada('A_ONE', false, HALF_CLEAR), 'glass'],
  ['A_ONE, stripes', collada('A_ONE', false, STRIPES), 'cut out'],
  ['A_ONE, stripes on a colour', collada('A_ONE', true, STRIPES), 'cut out'],
  ['A_ONE, grey on a colour', collada('A_ONE', true, GREY), 'glass'],
  ['RGB_ZERO, grey', collada('RGB_ZERO', false, GREY), 'glass'],
  ['RGB_ZERO, black', collada('RGB_ZERO', true, picture([0, 0, 0, 255])), 'opaque'],
])('a surface with %s is seen through as its picture says', async (_, files, kind) => {
  const model = await readModel(
    Object.entries(files).map(([name, content]) => file(name, content)),
    () => {},
    new NodeSurroundings('.'),
  );
  if (model.kind !== 'mesh') throw new Error('It is no mesh.');
  const { picture: index, isSeeThrough } = model.mesh.ranges!.at(-1)!;
  const cutOut = model.pictures[index]?.cutOut ?? -1;
  expect(isSeeThrough ? 'glass' : cutOut > 0 ? 'cut out' : 'opaque').toBe(kind);
  expect(model.notes).toEqual([]);
});

test('alpha that would hide everything is ignored', async () => {
  const rows = BOX_FACES.map((face) => [face, 255, 0, 0, 0]);
  const properties = [CORNER_LIST, ...RGBA.map((name) => `uchar ${name}`)];
  const tables = [
    { name: 'vertex', properties: XYZ, rows: BOX_CORNERS },
    { name: 'face', properties, rows },
  ];
  const box = await read(['box.ply', ply(tables)]);
  expect([triangles(box), box.mesh.ranges]).toEqual([12, undefined]);
});

test('reports lines and pictures that are not drawn', async () => {
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

test('surfaces without a material are white', async () => {
  const bare = wrl().replace(/appearance Appearance \{.*\}/g, '');
  expect(new Set(colorsOf(await read(['box.wrl', bare])))).toEqual(new Set(['none']));
  const unbound = dae().replace(/<bind_material>[\s\S]*<\/bind_material>/, '');
  expect(new Set(colorsOf(await read(['box.dae', unbound])))).toEqual(new Set(['none']));
});
