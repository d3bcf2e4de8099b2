import { AsciiReader } from '../common/AsciiReader.js';
import { ModelError } from '../common/ModelError.js';
import { nearFloats } from '../mesh/fitModel.js';
import { checkReadTriangles, type NotedMesh, normalizeNormals, type PlainMesh } from '../mesh/PlainMesh.js';
import { cutPolygons } from '../mesh/triangulatePolygon.js';
import { fullValue, linearColors, meanAlpha, rangesByAlpha, withFaceColors } from '../mesh/vertexColors.js';
import { GrowingIndices } from './GrowingIndices.js';

/**
 * The keyword at the beginning, with prefixes for texture coordinates (ST), colours (C), normals (N) and a fourth coordinate (4) of
 * vertices.
 */
const KEYWORD = /^(ST)?(C)?(N)?(4)?(n)?OFF/;
/** The minimum size of a number, with the blank after it, in bytes. */
const LEAST_NUMBER_BYTES = 2;

interface Header {
  hasNormals: boolean;
  /** Whether the fourth number of a colour is alpha; otherwise it is a texture coordinate. */
  hasAlpha: boolean;
  /** The number of coordinates of a vertex. */
  size: number;
  vertices: number;
  faces: number;
}

/**
 * Reads a text OFF file (Object File Format): faces with any number of corners, normals, and colours of faces or, preferably, of vertices,
 * as integers up to 255 or as fractions. Vertices may have colours even if the keyword has no C.
 *
 * @throws ModelError if it is binary, damaged or truncated
 */
export function readOff(bytes: Uint8Array, name: string): NotedMesh {
  const reader = new AsciiReader(bytes);
  const header = readHeader(reader, name);
  const { positions, normals, colors, alphas } = readVertices(reader, header, name);
  const { indices, polygons, hasLines, ...faces } = readFaces(reader, header, name);
  checkReadTriangles(indices.length / 3);
  cutPolygons(positions, indices, polygons);
  const full = colors ? fullValue(colors) : 1;
  const plain: PlainMesh = {
    positions: nearFloats(positions, indices),
    normals,
    colors: colors && linearColors(colors, full),
    indices,
  };
  const notes = hasLines ? ['points and lines left out'] : [];
  if (!faces.isColoured) {
    const vertexAlpha =
      alphas &&
      meanAlpha(
        alphas.map((alpha) => alpha / full),
        indices,
      );
    return { mesh: vertexAlpha ? rangesByAlpha(plain, vertexAlpha) : plain, notes };
  }
  const faceFull = fullValue(faces.colors);
  const mesh = withFaceColors(plain, linearColors(faces.colors, faceFull));
  return { mesh: rangesByAlpha(mesh, (triangle) => opacityOf(faces.alphas[triangle] / faceFull)), notes };
}

/** A missing alpha is opaque. */
const opacityOf = (alpha: number): number => (Number.isFinite(alpha) ? alpha : 1);

function readHeader(reader: AsciiReader, name: string): Header {
  skipComments(reader);
  const keyword = KEYWORD.exec(reader.peekWord())?.[0] ?? '';
  reader.skip(keyword.length);
  skipComments(reader);
  if (/^BINARY$/i.test(reader.peekWord())) {
    throw new ModelError(`${name} is a binary OFF file, which this page does not read; save it as text, or as PLY.`);
  }
  if (keyword.includes('n') && reader.number() !== 3) {
    throw new ModelError(`${name} has points with other than three coordinates, which cannot be drawn.`);
  }
  skipComments(reader);
  const [vertices, faces] = [reader.number(), reader.number()];
  for (const count of [vertices, faces]) {
    if (!Number.isInteger(count) || count < 0)
      throw new ModelError(`${name} is damaged: it does not say how many points and faces it holds.`);
  }
  // The number of edges, which may be missing.
  reader.skipLine();
  const size = keyword.includes('4') ? 4 : 3;
  if (LEAST_NUMBER_BYTES * (size * vertices + faces) > reader.bytesLeft + 1) {
    throw new ModelError(`${name} is cut short: it announces more points and faces than it holds.`);
  }
  return {
    hasNormals: keyword.includes('N'),
    hasAlpha: keyword.includes('C') || !keyword.includes('ST'),
    size,
    vertices,
    faces,
  };
}

function readVertices(
  reader: AsciiReader,
  { hasNormals, hasAlpha, size, vertices }: Header,
  name: string,
): { positions: Float64Array; normals: Float32Array | null; colors: Float64Array | null; alphas: Float64Array | null } {
  const positions = new Float64Array(3 * vertices);
  const normals = hasNormals ? new Float32Array(3 * vertices) : null;
  let colors: Float64Array | null = null;
  let alphas: Float64Array | null = null;
  const row = [0, 0, 0, 1];
  for (let vertex = 0; vertex < vertices; vertex++) {
    startRow(reader, name);
    for (let i = 0; i < size; i++) row[i] = reader.number();
    for (let axis = 0; axis < 3; axis++) positions[3 * vertex + axis] = row[axis] / row[3];
    for (let k = 0; normals && k < 3; k++) normals[3 * vertex + k] = reader.number();
    const rest = restOfLine(reader);
    if (rest.length < 3) continue;
    // Vertices without a colour are white where others have one.
    colors ??= new Float64Array(3 * vertices).fill(Number.NaN);
    for (let k = 0; k < 3; k++) colors[3 * vertex + k] = rest[k];
    if (rest.length < 4 || !hasAlpha) continue;
    alphas ??= new Float64Array(vertices).fill(Number.NaN);
    alphas[vertex] = rest[3];
  }
  return { positions, normals: normals && normalizeNormals(normals), colors, alphas };
}

/** Reads the faces as triangle fans, with a colour and an alpha for each; missing ones are NaN. */
function readFaces(
  reader: AsciiReader,
  { faces }: Header,
  name: string,
): {
  indices: Uint32Array;
  polygons: number[];
  colors: number[];
  alphas: number[];
  isColoured: boolean;
  hasLines: boolean;
} {
  const indices = new GrowingIndices();
  const polygons: number[] = [];
  const colors: number[] = [];
  const alphas: number[] = [];
  let isColoured = false;
  let hasLines = false;
  for (let face = 0; face < faces; face++) {
    startRow(reader, name);
    const count = reader.number();
    if (!(count >= 0 && LEAST_NUMBER_BYTES * count <= reader.bytesLeft + 1))
      throw new ModelError(`${name} is cut short or damaged: one of its faces has more corners than the file.`);
    const before = indices.length;
    const first = count > 0 ? reader.number() : 0;
    let previous = count > 1 ? reader.number() : 0;
    for (let corner = 2; corner < count; corner++) {
      const next = reader.number();
      indices.add(first, previous, next);
      previous = next;
    }
    if (count > 3) polygons.push(before, indices.length);
    const rest = restOfLine(reader);
    // A single number is an index into a colour map, which the file does not contain.
    const [red, green, blue, alpha = Number.NaN] = rest.length >= 3 ? rest : [Number.NaN, Number.NaN, Number.NaN];
    isColoured ||= rest.length >= 3;
    hasLines ||= count === 1 || count === 2;
    for (let i = before; i < indices.length; i += 3) {
      colors.push(red, green, blue);
      alphas.push(alpha);
    }
  }
  return { indices: indices.values(), polygons, colors, alphas, isColoured, hasLines };
}

function startRow(reader: AsciiReader, name: string): void {
  skipComments(reader);
  if (reader.isAtEnd) throw new ModelError(`${name} is cut short: it announces more points and faces than it holds.`);
}

function skipComments(reader: AsciiReader): void {
  while (reader.isAt('#')) reader.skipLine();
}

/** The remaining numbers of the line. */
function restOfLine(reader: AsciiReader): number[] {
  const numbers: number[] = [];
  while (!reader.isAtLineEnd) numbers.push(reader.number());
  return numbers;
}
