import { describe, expect, test } from 'vitest';
import type { ReadMesh } from '../../../../../src/viewer/files/readModel.js';
import {
  CORNER_LIST,
  measure,
  type PlyFormat,
  ply,
  read,
  triangles,
  XYZ,
} from '../../../../../tools/modelFiles/modelWriters.js';
import { COMB } from '../comb.js';

type Point = readonly [number, number];

/** A solid between an outline on the floor and the same above it, whose faces have as many corners as they need. */
interface Solid {
  corners: number[][];
  faces: number[][];
  area: number;
  volume: number;
}

function extruded(outline: readonly Point[], plan: number): Solid {
  const count = outline.length;
  const corners = [0, 1].flatMap((z) => outline.map(([x, y]) => [x, y, z]));
  const sides = outline.map((_, i) => [i, (i + 1) % count, count + ((i + 1) % count), count + i]);
  const around = outline.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = outline[(i + 1) % count];
    return sum + Math.hypot(nextX - x, nextY - y);
  }, 0);
  const floor = outline.map((_, i) => count - 1 - i);
  const roof = outline.map((_, i) => count + i);
  return { corners, faces: [floor, roof, ...sides], area: 2 * plan + around, volume: plan };
}

// Both begin beside a notch, where a fan around the first corner lies over it.
const ARROW: Point[] = [
  [4, 2],
  [0, 4],
  [1, 2],
  [0, 0],
];

const lists = (rows: readonly (readonly number[])[], end = ''): string =>
  rows.map((row) => row.join(' ') + end).join(' ');

const obj = ({ corners, faces }: Solid): string =>
  [
    ...corners.map((corner) => `v ${corner.join(' ')}`),
    ...faces.map((face) => `f ${face.map((i) => i + 1).join(' ')}`),
  ].join('\n');

const backwardObj = (solid: Solid): string =>
  obj(solid).replace(/^f .*$/gm, (line) => line.replace(/\d+/g, (i) => String(Number(i) - 1 - solid.corners.length)));

const plyOf = ({ corners, faces }: Solid, format: PlyFormat): Uint8Array =>
  ply(
    [
      { name: 'face', properties: [CORNER_LIST], rows: faces.map((face) => [face]) },
      { name: 'vertex', properties: XYZ, rows: corners },
    ],
    format,
  );

/** @param primitives the elements with the faces */
const daeWith = (
  { corners }: Pick<Solid, 'corners'>,
  primitives: (input: string) => string,
): string => `<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><up_axis>Y_UP</up_axis></asset>
  <library_geometries><geometry id="solid"><mesh>
    <source id="points"><float_array id="array" count="${3 * corners.length}">${lists(corners)}</float_array>
      <technique_common><accessor source="#array" count="${corners.length}" stride="3"/></technique_common></source>
    <vertices id="vertices"><input semantic="POSITION" source="#points"/></vertices>
    ${primitives('<input semantic="VERTEX" source="#vertices" offset="0"/>')}
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene"><node><instance_geometry url="#solid"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>`;

const polylist = (solid: Solid): string =>
  daeWith(
    solid,
    (input) =>
      `<polylist count="${solid.faces.length}">${input}<vcount>${lists(solid.faces.map(({ length }) => [length]))}</vcount><p>${lists(solid.faces)}</p></polylist>`,
  );

const polygons = (solid: Solid): string =>
  daeWith(
    solid,
    (input) =>
      `<polygons count="${solid.faces.length}">${input}${solid.faces.map((face) => `<p>${face.join(' ')}</p>`).join('')}</polygons>`,
  );

const wrl = ({ corners, faces }: Solid, isBackward: boolean): string => `#VRML V2.0 utf8
Shape { geometry IndexedFaceSet {
  ${isBackward ? 'ccw FALSE' : ''}
  coord Coordinate { point [ ${lists(corners, ',')} ] }
  coordIndex [ ${faces.map((face) => `${(isBackward ? [...face].reverse() : face).join(', ')}, -1`).join(', ')} ]
} }`;

const usda = ({ corners, faces }: Solid): string => `#usda 1.0
def Mesh "solid"
{
    int[] faceVertexCounts = [${faces.map(({ length }) => length).join(', ')}]
    int[] faceVertexIndices = [${faces.flat().join(', ')}]
    point3f[] points = [${corners.map((corner) => `(${corner.join(', ')})`).join(', ')}]
}
`;

/** The distance of the farthest corner from the middle, by which a model is made smaller. */
function radiusOf(corners: readonly (readonly number[])[]): number {
  const middle = [0, 1, 2].map((axis) => {
    const values = corners.map((corner) => corner[axis]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  });
  return Math.max(...corners.map((corner) => Math.hypot(...corner.map((x, axis) => x - middle[axis]))));
}

function expectSolid(model: ReadMesh, { corners, area, volume }: Omit<Solid, 'faces'>): void {
  const radius = radiusOf(corners);
  const measured = measure(model);
  expect(measured.area).toBeCloseTo(area / radius ** 2, 4);
  expect(measured.volume).toBeCloseTo(volume / radius ** 3, 4);
}

const writers: [name: string, write: (solid: Solid) => string | Uint8Array][] = [
  ['solid.obj', obj],
  ['backward.obj', backwardObj],
  ['text.ply', (solid) => plyOf(solid, 'ascii')],
  ['binary.ply', (solid) => plyOf(solid, 'binary_little_endian')],
  ['list.dae', polylist],
  ['polygons.dae', polygons],
  ['forward.wrl', (solid) => wrl(solid, false)],
  ['backward.wrl', (solid) => wrl(solid, true)],
  ['solid.usda', usda],
];

describe.each(writers)('polygons of %s', (name, write) => {
  test.each([
    ['four corners', extruded(ARROW, 6)],
    ['many corners', extruded(COMB, 18)],
  ])('with %s keep their notches', async (_what, solid) => {
    const model = await read([name, write(solid)]);
    expect(triangles(model)).toBe(solid.faces.reduce((sum, { length }) => sum + length - 2, 0));
    expectSolid(model, solid);
  });
});

test('holes of COLLADA stay open, and its strips and fans are drawn', async () => {
  const square = (side: number): Point[] => [
    [-side, -side],
    [side, -side],
    [side, side],
    [-side, side],
  ];
  const [outer, inner] = [extruded(square(2), 16), extruded(square(1), 4)];
  const corners = [...outer.corners, ...inner.corners];
  const inside = ([a, b, c, d]: number[]): number[] => [d + 8, c + 8, b + 8, a + 8];
  const content = daeWith(
    { corners },
    (input) => `<polygons count="2">${input}
      ${outer.faces
        .slice(0, 2)
        .map((face, i) => `<ph><p>${face.join(' ')}</p><h>${inner.faces[i].map((k) => k + 8).join(' ')}</h></ph>`)
        .join('')}</polygons>
      <tristrips count="1">${input}<p>0 4 1 5 2 6 3 7 0 4</p></tristrips>
      <trifans count="4">${input}${inner.faces
        .slice(2)
        .map((face) => `<p>${inside(face).join(' ')}</p>`)
        .join('')}</trifans>`,
  );
  const model = await read(['frame.dae', content]);
  // The strip turns inwards as it is written here.
  expect(measure(model).area).toBeCloseTo((2 * 12 + 16 + 8) / radiusOf(corners) ** 2, 4);
  expect(triangles(model)).toBe(2 * 8 + 8 + 8);
});

describe('normals of a file that has none', () => {
  const solid = extruded(ARROW, 6);
  const zeros = async (name: string, content: string): Promise<boolean[]> => {
    const { normals = null, positions } = (await read([name, content])).mesh;
    return [...new Set(positions.map((_, i) => Math.abs(normals?.[i] ?? 0)))].map((size) => size === 0);
  };

  test.each<[string, string]>([
    ['solid.obj', obj(solid)],
    ['solid.dae', polylist(solid)],
    ['solid.wrl', wrl(solid, false)],
    ['solid.usda', usda(solid)],
  ])('are left to be computed, with edges kept: %s', async (name, content) => {
    expect(await zeros(name, content)).toEqual([true]);
  });

  test('are those that a file of VRML asks for', async () => {
    expect(await zeros('solid.wrl', wrl(solid, false).replace('coord ', 'creaseAngle 3 coord '))).toContain(false);
  });
});
