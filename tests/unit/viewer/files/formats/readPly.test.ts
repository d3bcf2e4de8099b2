import { describe, expect, test } from 'vitest';
import { BOX_CORNERS, BOX_FACES } from '../../../../../tools/modelFiles/box.js';
import {
  CORNER_LIST,
  colorsOf,
  measure,
  type PlyFormat,
  type PlyTable,
  PRISM_CORNERS,
  PRISM_FACES,
  ply,
  prismPly,
  read,
  refusal,
  triangles,
  XYZ,
} from '../../../../../tools/modelFiles/modelWriters.js';

const FORMATS: PlyFormat[] = ['ascii', 'binary_little_endian', 'binary_big_endian'];
const boxVertices: PlyTable = { name: 'vertex', properties: XYZ, rows: BOX_CORNERS };
const boxFaces: PlyTable = { name: 'face', properties: [CORNER_LIST], rows: BOX_FACES.map((face) => [face]) };
const BOX_VOLUME = (2 / Math.sqrt(3)) ** 3;

describe.each(FORMATS)('PLY, %s', (format) => {
  test('faces with any number of corners', async () => {
    const prism = await read(['prism.ply', prismPly(format)]);
    expect(triangles(prism)).toBe(20);
    // Radius of the prism before it was fitted: from its middle to a corner.
    const radius = Math.hypot(1, 0.5);
    expect(measure(prism).volume).toBeCloseTo((1.5 * Math.sqrt(3)) / radius ** 3, 4);
    expect(measure(prism).area).toBeCloseTo((3 * Math.sqrt(3) + 6) / radius ** 2, 4);
    // Closed: every edge is passed once in each direction.
    const { indices } = prism.mesh;
    const edges = [...indices!].map((from, i) => `${from} ${indices![i % 3 === 2 ? i - 2 : i + 1]}`);
    expect(new Set(edges)).toEqual(new Set(edges.map((edge) => edge.split(' ').reverse().join(' '))));
    expect(new Set(edges).size).toBe(60);
    expect(prism.notes).toEqual([]);
  });

  test('reads triangles before and after a polygon, and negative indices', async () => {
    const [first, second, ...others] = BOX_FACES;
    const corners = (face: readonly number[]): number[][] => [face.slice(0, 3), [face[0], face[2], face[3]]];
    const rows = [...corners(first), second, ...others.flatMap(corners), [0, 1, -1]].map((face) => [face]);
    const box = await read(['box.ply', ply([boxVertices, { name: 'face', properties: [CORNER_LIST], rows }], format)]);
    expect(triangles(box)).toBe(12);
    expect(measure(box).volume).toBeCloseTo(BOX_VOLUME, 4);
    expect(box.details).toEqual([expect.stringMatching(/1 .*broken|1 .*left out/)]);
  });

  test('triangle strips, with breaks', async () => {
    // A box: one strip round its sides, and one for each of its ends.
    const strip = [0, 2, 1, 3, 5, 7, 4, 6, 0, 2, -1, 0, 1, 4, 5, -1, 2, 6, 3, 7];
    const box = await read([
      'strips.ply',
      ply([boxVertices, { name: 'tristrips', properties: ['list int int vertex_indices'], rows: [[strip]] }], format),
    ]);
    expect(triangles(box)).toBe(12);
    expect(measure(box).volume).toBeCloseTo(BOX_VOLUME, 4);
  });

  test('elements in any order, with lists and values of their own, and vertices as doubles far away', async () => {
    const far = BOX_CORNERS.map(([x, y, z], i) => [[i, 7], 5e6 + x, y, 9, z - 3e7]);
    const box = await read([
      'box.ply',
      ply(
        [
          { name: 'material', properties: ['uchar shininess', 'list ushort float weights'], rows: [[3, [1, 2]]] },
          {
            name: 'face',
            properties: ['uchar flags', 'list uchar float texcoord', 'list int uint vertex_index', 'short group'],
            rows: BOX_FACES.map((face, i) => [i, new Array(8).fill(0.5), face, 7]),
          },
          { name: 'nothing', properties: [], rows: new Array(3).fill([]) },
          {
            name: 'vertex',
            properties: ['list uchar int tags', 'double x', 'double y', 'int label', 'double z'],
            rows: far,
          },
        ],
        format,
      ),
    ]);
    expect(triangles(box)).toBe(12);
    expect(measure(box).volume).toBeCloseTo(BOX_VOLUME, 4);
  });

  test('colours of vertices and of faces', async () => {
    const colours = ['uchar red', 'uchar green', 'uchar blue'];
    const ofVertices = await read([
      'box.ply',
      ply(
        [
          {
            ...boxVertices,
            properties: [...XYZ, ...colours],
            rows: BOX_CORNERS.map((corner) => [...corner, 255, 128, 0]),
          },
          boxFaces,
        ],
        format,
      ),
    ]);
    expect(colorsOf(ofVertices)).toEqual(new Array(12).fill('255,128,0'));
    const ofFaces = await read([
      'box.ply',
      ply(
        [
          boxVertices,
          {
            ...boxFaces,
            properties: [CORNER_LIST, ...colours],
            rows: BOX_FACES.map((face, i) => [face, 40 * i, 0, 255]),
          },
        ],
        format,
      ),
    ]);
    expect(colorsOf(ofFaces)).toEqual(
      [0, 0, 40, 40, 80, 80, 120, 120, 160, 160, 200, 200].map((red) => `${red},0,255`),
    );
    expect(measure(ofFaces).volume).toBeCloseTo(BOX_VOLUME, 4);
    // As in three's loader, what a face says of itself counts for more than what its corners say.
    const ofBoth = await read([
      'box.ply',
      ply(
        [
          {
            ...boxVertices,
            properties: [...XYZ, ...colours],
            rows: BOX_CORNERS.map((corner) => [...corner, 255, 255, 255]),
          },
          {
            ...boxFaces,
            properties: [CORNER_LIST, ...colours],
            rows: BOX_FACES.map((face, i) => [face, 40 * i, 0, 0]),
          },
        ],
        format,
      ),
    ]);
    expect(new Set(colorsOf(ofBoth))).toEqual(new Set([0, 40, 80, 120, 160, 200].map((red) => `${red},0,0`)));
  });

  test('colours as floats, from 0 to 1 or to 255', async () => {
    for (const full of [1, 255]) {
      const box = await read([
        'box.ply',
        ply(
          [
            {
              ...boxVertices,
              properties: [...XYZ, 'float red', 'float green', 'float blue'],
              rows: BOX_CORNERS.map((corner) => [...corner, full, 0, 0]),
            },
            boxFaces,
          ],
          format,
        ),
      ]);
      expect(new Set(colorsOf(box))).toEqual(new Set(['255,0,0']));
    }
  });

  test('a header with comments and carriage returns', async () => {
    for (const end of ['\r', '\r\n']) {
      const header = (text: string): string =>
        text
          .replace('element vertex', 'comment the end_header is not here\nobj_info 3\nelement vertex')
          .replace('property list', 'comment\nproperty list')
          .replaceAll('\n', end);
      expect(triangles(await read(['prism.ply', prismPly(format, header)]))).toBe(20);
    }
  });

  test('data that begin as a line does', async () => {
    // A line feed, or a carriage return and a line feed.
    for (const first of [[10], [13, 10]]) {
      const prism = ply(
        [
          { name: 'mark', properties: first.map((_, i) => `uchar m${i}`), rows: [first] },
          { name: 'vertex', properties: XYZ, rows: PRISM_CORNERS },
          { name: 'face', properties: [CORNER_LIST], rows: PRISM_FACES.map((face) => [face]) },
        ],
        format,
        (text) => text.replaceAll('\n', first.length === 1 ? '\r' : '\n'),
      );
      expect(measure(await read(['prism.ply', prism])).volume).toBeCloseTo((1.5 * Math.sqrt(3)) / 1.25 ** 1.5, 4);
    }
  });

  test('normals that are zero are computed later, others have length 1', async () => {
    const { mesh } = await read([
      'box.ply',
      ply(
        [
          {
            ...boxVertices,
            properties: [...XYZ, 'float nx', 'float ny', 'float nz'],
            rows: BOX_CORNERS.map((corner, i) => [...corner, ...corner.map((at) => (i === 0 ? 0 : 10 * at - 5))]),
          },
          boxFaces,
        ],
        format,
      ),
    ]);
    expect([...mesh.normals!.subarray(0, 3)]).toEqual([0, 0, 0]);
    expect(mesh.normals![3]).toBeCloseTo(1 / Math.sqrt(3), 6);
    expect(mesh.normals![4]).toBeCloseTo(-1 / Math.sqrt(3), 6);
    expect(mesh.normals![5]).toBeCloseTo(-1 / Math.sqrt(3), 6);
  });

  test('what is cut short is said so', async () => {
    const whole = prismPly(format);
    expect(await refusal(['cut.ply', whole.subarray(0, whole.length - 20)])).toMatch(/^cut\.ply is cut short/);
    const promising = ply([{ ...boxVertices, rows: BOX_CORNERS }, boxFaces], format, (text) =>
      text.replace('vertex 8', 'vertex 4000000000'),
    );
    expect(await refusal(['much.ply', promising])).toBe(
      'much.ply is cut short: it announces 4,000,000,000 points and ends before them.',
    );
    const list = { ...boxFaces, properties: ['list uint int vertex_indices'], rows: [[[0, 1, 2]]] };
    const long = ply([boxVertices, list], format, (text) => text);
    const at = long.length - (format === 'ascii' ? 8 : 16);
    long.set(new TextEncoder().encode(format === 'ascii' ? '9' : '\x0f\x0f\x0f\x0f'), at);
    expect(await refusal(['long.ply', long])).toBe(
      'long.ply is cut short or damaged: one of its lists is longer than the file.',
    );
  });

  test('four thousand million rows without values take no time', async () => {
    const header = (text: string): string => text.replace('element face', 'element nothing 4000000000\nelement face');
    expect(triangles(await read(['prism.ply', prismPly(format, header)]))).toBe(20);
  });
});

test('comments between rows, also where a row is a number alone', async () => {
  const text = new TextDecoder().decode(prismPly('ascii'));
  const [head, body] = text.split(/(?<=end_header\n)/);
  const commented = `${head}comment 1 2 3\n\n${body!.replace(/\n/g, '\n  comment of a row, 7 8 9\r\n# 7\nobj_info 1\n')}`;
  const prism = await read(['prism.ply', commented]);
  expect(measure(prism)).toEqual(measure(await read(['prism.ply', text])));
  expect(prism.notes).toEqual([]);
});

describe('PLY files that hold no surface', () => {
  test('points are refused by name', async () => {
    const points = ply([{ name: 'vertex', properties: XYZ, rows: PRISM_CORNERS }]);
    expect(await refusal(['points.ply', points])).toBe(
      'points.ply holds points but no triangles; only surfaces can be hatched.',
    );
    const lines = ply([
      { name: 'vertex', properties: XYZ, rows: PRISM_CORNERS },
      { name: 'face', properties: [CORNER_LIST], rows: PRISM_FACES.map((face) => [face.slice(0, 2)]) },
    ]);
    expect(await refusal(['lines.ply', lines])).toMatch(/^The file holds no triangles/);
  });

  test('Gaussian splats are refused by name', async () => {
    const properties = [...XYZ, 'float f_dc_0', 'float opacity', 'float scale_0', 'float rot_0'];
    const splats = ply([{ name: 'vertex', properties, rows: [[0, 0, 0, 1, 1, 1, 1]] }], 'binary_little_endian');
    expect(await refusal(['cat.ply', splats])).toBe(
      'cat.ply holds Gaussian splats, not triangles; only surfaces can be hatched.',
    );
  });

  test('headers that cannot be understood', async () => {
    expect(await refusal(['a.ply', 'ply\nformat ascii 1.0\nelement vertex 3\n'])).toBe(
      'a.ply is cut short: its PLY header has no end.',
    );
    expect(await refusal(['b.ply', prismPly('ascii', (text) => text.replace('float x', 'quad x'))])).toBe(
      'b.ply is damaged: its header has a value of unknown kind (quad x).',
    );
    expect(await refusal(['c.ply', prismPly('ascii', (text) => text.replace('float x', 'float a'))])).toBe(
      'c.ply does not say where its points lie: it has no x, y and z.',
    );
    expect(await refusal(['d.ply', prismPly('ascii', (text) => text.replace('vertex 12', 'vertex many'))])).toBe(
      'd.ply is damaged: its header does not say how many "vertex" it holds.',
    );
  });
});
