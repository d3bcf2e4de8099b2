import type { ModelFile, ReadMesh } from '../../src/viewer/files/readModel.js';
import { readModel } from '../../src/viewer/files/readModel.js';
import { BOX_CORNERS, BOX_FACES } from './box.js';

/** Small files of every kind, written by code, and helpers that read them as the playground does. */

export type Content = string | Uint8Array;

export const file = (name: string, content: Content): ModelFile => ({
  name,
  content: new Blob([content as Uint8Array<ArrayBuffer>]),
});

/** Reads files that hold one mesh. */
export async function read(...files: [name: string, content: Content][]): Promise<ReadMesh> {
  const model = await readModel(
    files.map(([name, content]) => file(name, content)),
    () => {},
  );
  if (model.kind !== 'mesh') throw new Error(`${model.name} is not a mesh`);
  return model;
}

/** The message of the error that refuses a file. */
export async function refusal(...files: [name: string, content: Content][]): Promise<string> {
  return read(...files).then(
    () => 'It was read.',
    (error: Error) => error.message,
  );
}

export const triangles = ({ mesh }: ReadMesh): number => mesh.indices!.length / 3;

/** The colour of every triangle's first corner, as sRGB bytes. */
export function colorsOf({ mesh }: ReadMesh): string[] {
  const { colors, indices } = mesh;
  const byte = (linear: number): number =>
    Math.round(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055));
  return Array.from({ length: indices!.length / 3 }, (_, triangle) =>
    colors ? [...colors.subarray(3 * indices![3 * triangle], 3 * indices![3 * triangle] + 3)].map(byte).join() : 'none',
  );
}

/** The area of a mesh in the size it is drawn in, and the volume it encloses: wrong triangles change both. */
export function measure({ mesh: { positions, indices } }: ReadMesh): { area: number; volume: number } {
  let area = 0;
  let volume = 0;
  for (let corner = 0; corner < indices!.length; corner += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * indices![corner + k], 3 * indices![corner + k] + 3));
    const u = [0, 1, 2].map((i) => b[i] - a[i]);
    const v = [0, 1, 2].map((i) => c[i] - a[i]);
    const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    area += Math.hypot(...cross) / 2;
    volume += (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6;
  }
  return { area, volume };
}

/** Hexagons of radius 1 at z = 0 and z = 1: twelve points, two faces of six corners and six of four. */
export const PRISM_CORNERS = Array.from({ length: 12 }, (_, i) => [
  Math.cos((Math.PI * (i % 6)) / 3),
  Math.sin((Math.PI * (i % 6)) / 3),
  Math.floor(i / 6),
]);
export const PRISM_FACES = [
  [5, 4, 3, 2, 1, 0],
  [6, 7, 8, 9, 10, 11],
  ...Array.from({ length: 6 }, (_, i) => [i, (i + 1) % 6, 6 + ((i + 1) % 6), 6 + i]),
];

/** A box whose faces across x, y and z are red, green and blue, in one group. */
export const colouredBoxObj = [
  'mtllib box.mtl',
  'o box',
  'g all',
  ...BOX_CORNERS.map((corner) => `v ${corner.join(' ')}`),
  ...BOX_FACES.flatMap((face, i) => [
    ...(i % 2 === 0 ? [`usemtl ${['red', 'green', 'blue'][i / 2]}`] : []),
    `f ${face.map((corner) => corner + 1).join(' ')}`,
  ]),
].join('\n');

export const colouredBoxMtl = 'newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n';

export type PlyFormat = 'ascii' | 'binary_little_endian' | 'binary_big_endian';

/** A number of a PLY file, by its type, or a list of them. */
export type PlyValue = number | readonly number[];

export interface PlyTable {
  name: string;
  /** A property, such as `float x` or `list uchar int vertex_indices`. */
  properties: string[];
  rows: readonly (readonly PlyValue[])[];
}

const PLY_SIZES: Readonly<Record<string, number>> = {
  char: 1,
  uchar: 1,
  short: 2,
  ushort: 2,
  int: 4,
  uint: 4,
  float: 4,
  double: 8,
};

/** Writes a PLY file. `header` may change its header. */
export function ply(
  tables: readonly PlyTable[],
  format: PlyFormat = 'ascii',
  header = (text: string) => text,
): Uint8Array {
  const head = [
    'ply',
    `format ${format} 1.0`,
    ...tables.flatMap(({ name, properties, rows }) => [
      `element ${name} ${rows.length}`,
      ...properties.map((property) => `property ${property}`),
    ]),
    'end_header',
    '',
  ].join('\n');
  const chunks: Uint8Array[] = [new TextEncoder().encode(header(head))];
  for (const { properties, rows } of tables) {
    for (const row of rows) {
      if (format === 'ascii') {
        const words = row.flatMap((value) => (typeof value === 'number' ? [value] : [value.length, ...value]));
        chunks.push(new TextEncoder().encode(`${words.join(' ')}\n`));
        continue;
      }
      row.forEach((value, i) => {
        const [kind, ...types] = properties[i].split(' ');
        const isLittle = format === 'binary_little_endian';
        if (typeof value === 'number') chunks.push(number(kind, value, isLittle));
        else
          chunks.push(
            number(types[0], value.length, isLittle),
            ...value.map((item) => number(types[1], item, isLittle)),
          );
      });
    }
  }
  return Uint8Array.from(chunks.flatMap((chunk) => [...chunk]));
}

function number(type: string, value: number, isLittle: boolean): Uint8Array {
  const view = new DataView(new ArrayBuffer(PLY_SIZES[type]));
  if (type === 'float') view.setFloat32(0, value, isLittle);
  else if (type === 'double') view.setFloat64(0, value, isLittle);
  else if (view.byteLength === 1) view.setUint8(0, value);
  else if (view.byteLength === 2) view.setUint16(0, value, isLittle);
  else view.setUint32(0, value, isLittle);
  return new Uint8Array(view.buffer);
}

export const XYZ = ['float x', 'float y', 'float z'];
export const CORNER_LIST = 'list uchar int vertex_indices';

export const prismPly = (format?: PlyFormat, header?: (text: string) => string): Uint8Array =>
  ply(
    [
      { name: 'vertex', properties: XYZ, rows: PRISM_CORNERS },
      { name: 'face', properties: [CORNER_LIST], rows: PRISM_FACES.map((face) => [face]) },
    ],
    format,
    header,
  );

/** A binary STL file of a box, with the normals that are given. */
export function boxStl(normal: readonly number[], { header = '', rest = 0 } = {}): Uint8Array {
  const corners = BOX_FACES.flatMap(([a, b, c, d]) => [
    [a, b, c],
    [a, c, d],
  ]);
  const bytes = new Uint8Array(84 + 50 * corners.length + rest);
  bytes.set(new TextEncoder().encode(header));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, corners.length, true);
  corners.forEach((triangle, t) => {
    const values = [...normal, ...triangle.flatMap((corner) => BOX_CORNERS[corner])];
    values.forEach((value, i) => {
      view.setFloat32(84 + 50 * t + 4 * i, value, true);
    });
  });
  return bytes;
}

/** An ASCII STL file of one triangle. */
export const asciiStl = (normal: string, corners = ['0 0 0', '1 0 0', '0 1 0']): string =>
  `solid one\n facet normal ${normal}\n  outer loop\n${corners.map((corner) => `   vertex ${corner}\n`).join('')}  endloop\n endfacet\nendsolid one\n`;
