import { triangleOf } from '../corners.js';
import type { FormField } from '../form/FormField.js';
import { asPhase, forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';

/** A mesh that is part of a larger object. Plain data: it is posted to the worker. */
export interface Part {
  mesh: TriangleMesh;
  /** From its object space to the space that all parts share: a 4×4 matrix, column by column. */
  matrix: readonly number[];
}

/** All parts as one mesh. */
export interface JoinedParts {
  mesh: TriangleMesh;
  /** Part i has the corners from firstCorners[i] to firstCorners[i + 1] − 1. */
  firstCorners: readonly number[];
}

/** Whether a matrix mirrors, which turns triangles inside out. */
function mirrors([a, b, c, , d, e, f, , g, h, i]: readonly number[]): boolean {
  return a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e) < 0;
}

/** Joins parts into one mesh in their shared space. Triangles of mirrored parts are reversed, so that their outside stays outside. */
export function* joinParts(parts: readonly Part[]): Generator<number, JoinedParts, void> {
  const firstVertices = [0];
  const firstCorners = [0];
  for (const [i, { mesh }] of parts.entries()) {
    firstVertices.push(firstVertices[i] + mesh.positions.length / 3);
    firstCorners.push(firstCorners[i] + mesh.indices.length);
  }
  const positions = new Float32Array(3 * firstVertices[parts.length]);
  const indices = new Uint32Array(firstCorners[parts.length]);
  for (const [i, { mesh, matrix }] of parts.entries()) {
    const share = i / parts.length;
    const vertexCount = mesh.positions.length / 3;
    yield* asPhase(
      forEachChunk(vertexCount, (start, end) =>
        placeRange(mesh.positions, matrix, positions, firstVertices[i], start, end),
      ),
      share,
      share,
    );
    const isMirrored = mirrors(matrix);
    yield* asPhase(
      forEachChunk(mesh.indices.length, (start, end) => {
        for (let corner = start; corner < end; corner++) {
          // An index out of range must not name a vertex of another part.
          const vertex = mesh.indices[cornerIn(corner, isMirrored)];
          indices[firstCorners[i] + corner] = vertex < vertexCount ? firstVertices[i] + vertex : NO_VERTEX;
        }
      }),
      share,
      share,
    );
  }
  return { mesh: { positions, indices }, firstCorners };
}

const NO_VERTEX = 0xffffffff;

/** The corner of a part at a place among all: reversed triangles exchange their last two corners. */
const cornerIn = (corner: number, isMirrored: boolean): number => {
  const place = isMirrored ? corner % 3 : 0;
  return place === 1 ? corner + 1 : place === 2 ? corner - 1 : corner;
};

/** Transforms the vertices of a range of a part and writes them to the whole. */
function placeRange(
  source: Float32Array,
  m: readonly number[],
  target: Float32Array,
  firstVertex: number,
  start: number,
  end: number,
): void {
  for (let vertex = start; vertex < end; vertex++) {
    const x = source[3 * vertex];
    const y = source[3 * vertex + 1];
    const z = source[3 * vertex + 2];
    const to = 3 * (firstVertex + vertex);
    for (let axis = 0; axis < 3; axis++)
      target[to + axis] = m[axis] * x + m[4 + axis] * y + m[8 + axis] * z + m[12 + axis];
  }
}

/** The number of the part of each triangle. */
export function partOfTriangles({ mesh, firstCorners }: JoinedParts): Uint32Array {
  const parts = new Uint32Array(mesh.indices.length / 3);
  for (let part = 1; part < firstCorners.length - 1; part++) {
    parts.fill(part, triangleOf(firstCorners[part]), triangleOf(firstCorners[part + 1]));
  }
  return parts;
}

/** Extracts the field of part `i` from that of the whole, in the object space of the part. */
export function* fieldOfPart(
  { firstCorners }: JoinedParts,
  i: number,
  { matrix }: Part,
  whole: FormField,
): Generator<number, FormField, void> {
  const first = firstCorners[i];
  const isMirrored = mirrors(matrix);
  const ofCorner = new Uint32Array(firstCorners[i + 1] - first);
  const own = new Int32Array(whole.count).fill(-1);
  const sources: number[] = [];
  yield* forEachChunk(ofCorner.length, (start, end) => {
    for (let corner = start; corner < end; corner++) {
      const source = whole.ofCorner[first + cornerIn(corner, isMirrored)];
      if (own[source] < 0) own[source] = sources.push(source) - 1;
      ofCorner[corner] = own[source];
    }
  });
  const count = sources.length;
  const field: FormField = {
    count,
    ofCorner,
    values: new Float32Array(2 * count),
    slopes: new Float32Array(3 * count),
    crossings: new Float32Array(3 * count),
    radius: whole.radius / largestScale(matrix),
    statistics: whole.statistics,
  };
  yield* forEachChunk(count, (start, end) => {
    for (let vertex = start; vertex < end; vertex++) {
      field.values[2 * vertex] = whole.values[2 * sources[vertex]];
      field.values[2 * vertex + 1] = whole.values[2 * sources[vertex] + 1];
      pullBack(matrix, whole.slopes, sources[vertex], field.slopes, vertex);
      pullBack(matrix, whole.crossings, sources[vertex], field.crossings, vertex);
    }
  });
  return field;
}

/** The length of the longest column of a matrix. */
const largestScale = (m: readonly number[]): number =>
  Math.max(...[0, 4, 8].map((column) => Math.hypot(m[column], m[column + 1], m[column + 2])));

/** Transforms a gradient to the space of a part: the transpose of its matrix times the gradient. */
function pullBack(m: readonly number[], from: Float32Array, source: number, to: Float32Array, vertex: number): void {
  const x = from[3 * source];
  const y = from[3 * source + 1];
  const z = from[3 * source + 2];
  for (let axis = 0; axis < 3; axis++) {
    to[3 * vertex + axis] = m[4 * axis] * x + m[4 * axis + 1] * y + m[4 * axis + 2] * z;
  }
}
