import { ModelError, shownName } from '../common/ModelError.js';
import { nearFloats } from '../mesh/fitModel.js';
import { checkReadTriangles, type NotedMesh, normalizeNormals, type PlainMesh } from '../mesh/PlainMesh.js';
import { cutPolygons } from '../mesh/triangulatePolygon.js';
import {
  type FaceColors,
  fullValue,
  linearColors,
  meanAlpha,
  rangesByAlpha,
  withFaceColors,
} from '../mesh/vertexColors.js';
import { GrowingIndices } from './GrowingIndices.js';
import {
  BinaryNumbers,
  leastRowBytes,
  type PlyColumn,
  type PlyElement,
  type PlyHeader,
  type PlyNumbers,
  type PlyProperty,
  plyNumbers,
  readColumns,
  readPlyHeader,
  readTriangles,
} from './plyParts.js';

/** Names of the properties that are drawn, in the order position, normal, colour, alpha. */
const COLUMNS: readonly (readonly string[])[] = [
  ['x', 'px', 'posx'],
  ['y', 'py', 'posy'],
  ['z', 'pz', 'posz'],
  ['nx', 'normalx', 'normal_x'],
  ['ny', 'normaly', 'normal_y'],
  ['nz', 'normalz', 'normal_z'],
  ['red', 'diffuse_red', 'r', 'diffuse_r'],
  ['green', 'diffuse_green', 'g', 'diffuse_g'],
  ['blue', 'diffuse_blue', 'b', 'diffuse_b'],
  ['alpha', 'diffuse_alpha', 'a', 'diffuse_a'],
];
const NORMAL = 3;
const COLOR = 6;
const ALPHA = 9;
const CORNERS = /^vertex_?(indices|indexes|index)$/;

/**
 * Reads a PLY file: ASCII or binary of either byte order, elements in any order, faces with any number of corners, triangle strips, and
 * colours and alpha of vertices or, preferably, of faces. three's own loader silently drops triangle strips and faces of more than four
 * corners.
 *
 * @throws ModelError if it contains only points or splats, or is truncated
 */
export function readPly(bytes: Uint8Array, name: string): NotedMesh {
  const header = readPlyHeader(bytes, name);
  checkElements(header, name);
  const numbers = plyNumbers(bytes, header);
  const indices = new GrowingIndices();
  let points: Points | undefined;
  let faces: Faces = {};
  const polygons: number[] = [];
  for (const element of header.elements) {
    checkLength(element, header.format, numbers, name);
    if (element.name === 'vertex') points = readPoints(element, numbers, name);
    else if (element.name === 'face') faces = readFaces(element, numbers, indices, polygons, name);
    else if (element.name === 'tristrips') readStrips(element, numbers, indices, name);
    else skipRows(element, numbers, name);
  }
  checkReadTriangles(indices.length / 3);
  const corners = indices.values();
  const { positions, alphas, ...others } = points!;
  cutPolygons(positions, corners, polygons);
  const plain: PlainMesh = {
    ...others,
    positions: positions instanceof Float64Array ? nearFloats(positions, corners) : positions,
    indices: corners,
  };
  const mesh = faces.colors ? withFaceColors(plain, faces.colors) : plain;
  const { alphas: ofFaces } = faces;
  const alphaOf = ofFaces ? (triangle: number): number => ofFaces[triangle] : alphas && meanAlpha(alphas, corners);
  return { mesh: alphaOf ? rangesByAlpha(mesh, alphaOf) : mesh, notes: notesOn(header) };
}

interface Points extends Pick<PlainMesh, 'normals' | 'colors'> {
  /** In double precision where the file may need it. */
  positions: Float32Array | Float64Array;
  /** Alpha per vertex, in [0, 1]. */
  alphas: Float32Array | null;
}

/** Data per triangle, where the file has them. */
interface Faces {
  colors?: FaceColors | undefined;
  /** Alpha in [0, 1]. */
  alphas?: Float32Array | undefined;
}

function notesOn({ elements, picture }: PlyHeader): string[] {
  const hasLines = elements.some(({ name, count }) => name === 'edge' && count > 0);
  return [
    ...(hasLines ? ['points and lines left out'] : []),
    ...(picture ? [`without ${shownName(picture)}: pictures on PLY are not read`] : []),
  ];
}

function checkElements({ elements }: PlyHeader, name: string): void {
  const vertex = elements.find((element) => element.name === 'vertex');
  const has = (property: string): boolean => vertex?.properties.some((other) => other.name === property) ?? false;
  if ((has('f_dc_0') && has('rot_0')) || has('packed_position')) {
    throw new ModelError(`${name} holds Gaussian splats, not triangles; only surfaces can be hatched.`);
  }
  if (!vertex?.count) throw new ModelError(`${name} holds no points.`);
  if (!COLUMNS.slice(0, NORMAL).every((names) => names.some(has))) {
    throw new ModelError(`${name} does not say where its points lie: it has no x, y and z.`);
  }
  if (!elements.some((element) => element.count > 0 && /^(face|tristrips)$/.test(element.name))) {
    throw new ModelError(`${name} holds points but no triangles; only surfaces can be hatched.`);
  }
}

function checkLength(element: PlyElement, format: PlyHeader['format'], numbers: PlyNumbers, name: string): void {
  // The last number of an ASCII file needs no space after it.
  if (element.count * leastRowBytes(element, format) <= numbers.bytesLeft + 1) return;
  const what = element.name === 'vertex' ? 'points' : element.name === 'face' ? 'faces' : `"${element.name}"`;
  throw new ModelError(
    `${name} is cut short: it announces ${element.count.toLocaleString('en')} ${what} and ends before them.`,
  );
}

function readPoints(element: PlyElement, numbers: PlyNumbers, name: string): Points {
  const { count, properties } = element;
  const slots = properties.map((property) => COLUMNS.findIndex((names) => names.includes(property.name)));
  const row = new Float64Array(COLUMNS.length);
  const has = (first: number): boolean => [0, 1, 2].every((i) => slots.includes(first + i));
  // Text, doubles and large integers may be map coordinates, for which single precision is too coarse.
  const isSingle =
    numbers instanceof BinaryNumbers &&
    properties.every(({ type }, i) => slots[i] < 0 || slots[i] >= NORMAL || !/64|32$/.test(type) || type === 'float32');
  const positions = isSingle ? new Float32Array(3 * count) : new Float64Array(3 * count);
  const normals = has(NORMAL) ? new Float32Array(3 * count) : null;
  const colors = has(COLOR) ? new Float64Array(3 * count) : null;
  const alphas = slots.includes(ALPHA) ? new Float32Array(count) : null;
  const [red, alpha] = [COLOR, ALPHA].map((slot) => properties[slots.indexOf(slot)]);
  const read = (): Points => ({
    positions,
    normals: normals && normalizeNormals(normals),
    colors: colors && toLinear(colors, red),
    alphas: alphas && toShares(alphas, alpha),
  });
  if (numbers instanceof BinaryNumbers) {
    const columns = properties.flatMap((property, i): PlyColumn[] => {
      const target = [positions, normals, colors, alphas][Math.floor(slots[i] / 3)];
      return target ? [{ property, target, axis: slots[i] % 3, step: slots[i] === ALPHA ? 1 : 3 }] : [];
    });
    if (readColumns(element, numbers, columns)) return read();
  }
  for (let vertex = 0; vertex < count; vertex++) {
    numbers.startRow();
    for (let i = 0; i < properties.length; i++) {
      const property = properties[i];
      if (property.countType) skipList(property, numbers, name);
      else if (slots[i] === -1) numbers.next(property.type);
      else row[slots[i]] = numbers.next(property.type);
    }
    const at = 3 * vertex;
    for (let axis = 0; axis < 3; axis++) {
      positions[at + axis] = row[axis];
      if (normals) normals[at + axis] = row[NORMAL + axis];
      if (colors) colors[at + axis] = row[COLOR + axis];
    }
    if (alphas) alphas[vertex] = row[ALPHA];
  }
  return read();
}

/** Reads faces. `polygons` receives the ranges of faces with more than three corners. @returns their other data */
function readFaces(
  element: PlyElement,
  numbers: PlyNumbers,
  indices: GrowingIndices,
  polygons: number[],
  name: string,
): Faces {
  const { count, properties } = element;
  const corners = cornerList(properties);
  const slots = properties.map((property) => COLUMNS.findIndex((names) => names.includes(property.name)) - COLOR);
  const colors = [0, 1, 2].every((slot) => slots.includes(slot)) ? ([] as number[]) : undefined;
  const alphas = slots.includes(ALPHA - COLOR) ? ([] as number[]) : undefined;
  const [r, g, b, a] = [0, 1, 2, 3];
  const color = [0, 0, 0, 0];
  const read = numbers instanceof BinaryNumbers ? readTriangles(element, numbers, indices) : 0;
  for (let face = read; face < count; face++) {
    const before = indices.length;
    numbers.startRow();
    properties.forEach((property, i) => {
      if (i === corners) readPolygon(property, numbers, indices, name);
      else if (property.countType) skipList(property, numbers, name);
      else if (slots[i] >= 0) color[slots[i]] = numbers.next(property.type);
      else numbers.next(property.type);
    });
    if (indices.length > before + 3) polygons.push(before, indices.length);
    for (let corner = before; corner < indices.length; corner += 3) {
      colors?.push(color[r], color[g], color[b]);
      alphas?.push(color[a]);
    }
  }
  const typeOf = (slot: number): PlyProperty => properties[slots.indexOf(slot)];
  return {
    colors: colors && toLinear(colors, typeOf(r)),
    alphas: alphas && toShares(Float32Array.from(alphas), typeOf(a)),
  };
}

/** Adds a fan of triangles around the first corner. */
function readPolygon(property: PlyProperty, numbers: PlyNumbers, indices: GrowingIndices, name: string): void {
  const count = listLength(property, numbers, name);
  const first = count > 0 ? numbers.next(property.type) : 0;
  let previous = count > 1 ? numbers.next(property.type) : 0;
  for (let corner = 2; corner < count; corner++) {
    const next = numbers.next(property.type);
    indices.add(first, previous, next);
    previous = next;
  }
}

/** Adds the triangles of strips. Every other triangle is reversed; -1 begins a new strip. */
function readStrips(
  { count, properties }: PlyElement,
  numbers: PlyNumbers,
  indices: GrowingIndices,
  name: string,
): void {
  const corners = cornerList(properties);
  for (let row = 0; row < count; row++) {
    numbers.startRow();
    properties.forEach((property, i) => {
      if (i !== corners) {
        if (property.countType) skipList(property, numbers, name);
        else numbers.next(property.type);
        return;
      }
      let length = 0;
      let a = 0;
      let b = 0;
      for (let left = listLength(property, numbers, name); left > 0; left--) {
        const c = numbers.next(property.type);
        length = c === -1 ? 0 : length + 1;
        if (length >= 3) {
          if (length % 2 === 1) indices.add(a, b, c);
          else indices.add(b, a, c);
        }
        a = b;
        b = c;
      }
    });
  }
}

function skipRows({ count, properties }: PlyElement, numbers: PlyNumbers, name: string): void {
  // Rows without properties take no bytes, whatever their count.
  if (properties.length === 0) return;
  for (let row = 0; row < count; row++) {
    numbers.startRow();
    for (const property of properties) {
      if (property.countType) skipList(property, numbers, name);
      else numbers.next(property.type);
    }
  }
}

/** The property with the corner indices: by name, or else the first list. */
function cornerList(properties: readonly PlyProperty[]): number {
  const named = properties.findIndex(({ name, countType }) => countType && CORNERS.test(name));
  return named !== -1 ? named : properties.findIndex(({ countType }) => countType);
}

function skipList(property: PlyProperty, numbers: PlyNumbers, name: string): void {
  for (let left = listLength(property, numbers, name); left > 0; left--) numbers.next(property.type);
}

/** @throws ModelError if the list is longer than the rest of the file */
function listLength({ countType }: PlyProperty, numbers: PlyNumbers, name: string): number {
  const length = numbers.next(countType!);
  if (length >= 0 && length <= numbers.bytesLeft) return length;
  throw new ModelError(`${name} is cut short or damaged: one of its lists is longer than the file.`);
}

/** Converts sRGB values of a type to linear RGB in [0, 1]. NaN becomes white. */
function toLinear(values: ArrayLike<number>, { type }: PlyProperty): Float32Array {
  return linearColors(values, fullValueOf(values, type));
}

/** Scales values of a type to [0, 1], in place. NaN becomes opaque. */
function toShares(values: Float32Array, { type }: PlyProperty): Float32Array {
  const full = fullValueOf(values, type);
  for (let i = 0; i < values.length; i++) values[i] = Number.isFinite(values[i]) ? values[i] / full : 1;
  return values;
}

/** The value of full brightness. Floats usually go to 1, but some programs write 0 to 255. */
function fullValueOf(values: ArrayLike<number>, type: PlyProperty['type']): number {
  if (type === 'uint16' || type === 'int16') return 65535;
  return type.startsWith('float') ? fullValue(values) : 255;
}
