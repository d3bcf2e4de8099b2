import {
  buildTriangleAdjacency,
  consistentTwins,
  type TriangleAdjacency,
} from '../adjacency/buildTriangleAdjacency.js';
import { triangleOf } from '../corners.js';
import { disjointSets, join, rootOf } from '../disjointSets.js';
import { bakeChosenForm, bakeForm } from '../form/bakeForm.js';
import type { FormField } from '../form/FormField.js';
import { measureBounds } from '../measureBounds.js';
import { cutCreases } from '../normals/cutCreases.js';
import { asPhase, chunkPhase, forEachChunk } from '../phases.js';
import { type TriangleMesh, validateTriangleMesh } from '../TriangleMesh.js';
import { type FormRequest, nearnessOf } from './bakeSurface.js';

/** The input of `bakeJointForms`. Plain data: it is posted to the worker. */
export interface JointFormsRequest {
  parts: readonly Part[];
  /** As in `SurfaceRequest`. */
  creaseAngle: number;
  weldTolerance?: number | undefined;
  /** Axes are in the space that all parts share. */
  form: FormRequest;
}

/** The form of a part: its share of a field, `'light'` if the parts together have no form, or `'alone'` if the part meets no other. */
export type JointForm = FormField | 'light' | 'alone';

/** Vertices of different parts are transformed by different matrices, which costs some digits. */
const LEAST_TOLERANCE = 1e-5;

/**
 * Bakes form fields of parts whose borders meet as if they were one mesh, so that lines continue from part to part. Parts that meet no
 * other are skipped. Throws a RangeError for an invalid mesh.
 */
export function* bakeJointForms(request: JointFormsRequest): Generator<number, JointForm[], void> {
  const { parts } = request;
  const forms: JointForm[] = parts.map(() => 'alone');
  const all = yield* asPhase(jointSurface(parts, request), 0, 0.1);
  const groups = touching(all);
  const corners = groups.flat().reduce((sum, part) => sum + parts[part].mesh.indices.length, 0);
  let done = 0;
  for (const group of groups) {
    const begun = done / corners;
    const members = group.map((part) => parts[part]);
    for (const { mesh } of members) done += mesh.indices.length;
    const fields = yield* asPhase(
      groupForms(members, members.length === parts.length ? all : null, request),
      0.1 + 0.9 * begun,
      0.1 + (0.9 * done) / corners,
    );
    for (const [i, part] of group.entries()) forms[part] = fields[i];
  }
  return forms;
}

/** All parts as one surface. */
interface JointSurface {
  joined: JoinedParts;
  radius: number;
  adjacency: TriangleAdjacency;
  /** With NO_TWIN at creases and where windings contradict each other. */
  twins: Int32Array<ArrayBuffer>;
}

function* jointSurface(
  parts: readonly Part[],
  { creaseAngle, weldTolerance }: JointFormsRequest,
): Generator<number, JointSurface, void> {
  const joined = yield* asPhase(joinParts(parts), 0, 0.1);
  yield* asPhase(validateTriangleMesh(joined.mesh, 'bakeJointForms: the mesh'), 0.1, 0.2);
  const bounds = yield* asPhase(measureBounds(joined.mesh), 0.2, 0.3);
  const nearness = nearnessOf(bounds, Math.max(weldTolerance ?? 0, LEAST_TOLERANCE));
  const adjacency = yield* asPhase(buildTriangleAdjacency(joined.mesh, nearness), 0.3, 0.9);
  yield* asPhase(cutCreases(adjacency, creaseAngle), 0.9, 0.95);
  const twins = yield* asPhase(consistentTwins(adjacency), 0.95, 1);
  return { joined, radius: bounds.radius, adjacency, twins };
}

/** The groups of two or more parts that have neighbours across borders. */
function touching({ joined, twins }: JointSurface): number[][] {
  const partOf = partOfTriangles(joined);
  const count = joined.firstCorners.length - 1;
  const sets = disjointSets(count);
  for (let corner = 0; corner < twins.length; corner++) {
    if (twins[corner] < corner) continue;
    const a = partOf[triangleOf(corner)];
    const b = partOf[triangleOf(twins[corner])];
    if (a !== b) join(sets, a, b);
  }
  const groups = new Map<number, number[]>();
  for (let part = 0; part < count; part++) {
    const root = rootOf(sets, part);
    groups.set(root, [...(groups.get(root) ?? []), part]);
  }
  return [...groups.values()].filter(({ length }) => length > 1);
}

/** The forms of parts that are all joined to each other. */
function* groupForms(
  parts: readonly Part[],
  known: JointSurface | null,
  request: JointFormsRequest,
): Generator<number, JointForm[], void> {
  const { joined, radius, adjacency, twins } = known ?? (yield* asPhase(jointSurface(parts, request), 0, 0.1));
  const bakeField = request.form.isChosen ? bakeChosenForm : bakeForm;
  const whole = yield* asPhase(bakeField(joined.mesh, adjacency, twins, radius, request.form), 0.1, 0.95);
  const forms: JointForm[] = [];
  for (const [i, part] of parts.entries()) {
    forms.push(whole ? yield* asPhase(fieldOfPart(joined, i, part, whole), 0.95, 1) : 'light');
  }
  return forms;
}

/** A mesh that is part of a larger object. Plain data: it is posted to the worker. */
export interface Part {
  mesh: TriangleMesh;
  /** From its object space to the space that all parts share: a 4×4 matrix, column by column. */
  matrix: readonly number[];
}

/** All parts as one mesh. */
interface JoinedParts {
  mesh: TriangleMesh;
  /** Part i has the corners from firstCorners[i] to firstCorners[i + 1] − 1. */
  firstCorners: readonly number[];
}

/** Whether a matrix mirrors, which turns triangles inside out. */
function mirrors([a, b, c, , d, e, f, , g, h, i]: readonly number[]): boolean {
  return a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e) < 0;
}

/** Joins parts into one mesh in their shared space. Triangles of mirrored parts are reversed, so that their outside stays outside. */
function* joinParts(parts: readonly Part[]): Generator<number, JoinedParts, void> {
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
    yield* chunkPhase(vertexCount, share, share, (start, end) =>
      placeRange(mesh.positions, matrix, positions, firstVertices[i], start, end),
    );
    const isMirrored = mirrors(matrix);
    yield* chunkPhase(mesh.indices.length, share, share, (start, end) => {
      for (let corner = start; corner < end; corner++) {
        // An index out of range must not name a vertex of another part.
        const vertex = mesh.indices[cornerIn(corner, isMirrored)];
        indices[firstCorners[i] + corner] = vertex < vertexCount ? firstVertices[i] + vertex : NO_VERTEX;
      }
    });
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
function partOfTriangles({ mesh, firstCorners }: JoinedParts): Uint32Array {
  const parts = new Uint32Array(mesh.indices.length / 3);
  for (let part = 1; part < firstCorners.length - 1; part++) {
    parts.fill(part, triangleOf(firstCorners[part]), triangleOf(firstCorners[part + 1]));
  }
  return parts;
}

/** Extracts the field of part `i` from that of the whole, in the object space of the part. */
function* fieldOfPart(
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
