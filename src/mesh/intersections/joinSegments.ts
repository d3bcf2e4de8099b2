import { disjointSets, join, rootOf } from '../disjointSets.js';
import { asPhase } from '../phases.js';
import { type Crossings, SEGMENT } from './crossMeshes.js';
import type { Grid, MeetingMesh } from './MeetingMesh.js';

/** Numbers per segment of a line: its two ends, and the unit normals of the first and the second surface at each. */
export const LINE_FLOATS = 18;

/** Length below which segments and lines are left out, as a share of the diagonal of the smaller mesh. */
const SHORTEST = 1e-5;
/** Distance from an edge that has a line already within which there is no second one, as a share of the same diagonal. */
const BESIDE_EDGE = 2e-4;
/**
 * The sine of the angle between two surfaces below which they have no line: panels that nearly touch cut each other by chance, hair by hair.
 * Smooth normals count as well as faces, since on curved panels those differ.
 */
const LEAST_SINE = Math.sin((8 * Math.PI) / 180);
const LEAST_FACE_SINE = 0.01;

/** Segments per step. */
const CHUNK = 1024;

/**
 * Makes lines of segments: leaves out those of surfaces that nearly touch and those beside edges that have a line, closes up those that are
 * too short, and drops lines that are. The two sides of a segment are such that its surfaces form a valley. In the shared space. Yields its
 * progress.
 *
 * @param diagonal of the smaller mesh, in steps of the grid
 */
export function* joinSegments(
  { places, segments }: Crossings,
  first: MeetingMesh,
  second: MeetingMesh,
  diagonal: number,
  grid: Grid,
): Generator<number, Float64Array<ArrayBuffer>, void> {
  const ends = Float64Array.from(places);
  const joined = disjointSets(ends.length / 3);
  const shortest = SHORTEST * diagonal;
  for (let s = 0; s < segments.length; s += SEGMENT)
    if (lengthOf(ends, segments, s) < shortest) join(joined, segments[s], segments[s + 1]);
  // Ends that were joined are where the first of them is, so that lines stay in one piece.
  for (let i = 0; i < joined.length; i++) {
    const root = rootOf(joined, i);
    if (root !== i) ends.copyWithin(3 * i, 3 * root, 3 * root + 3);
  }
  yield 0.1;
  const { drawn, lines } = yield* asPhase(drawnOf(ends, segments, joined, first, second, diagonal), 0.1, 0.6);
  const lengths = new Float64Array(joined.length);
  const lineOf = (s: number): number => rootOf(lines, rootOf(joined, segments[s]));
  for (const s of drawn) lengths[lineOf(s)] += lengthOf(ends, segments, s);
  const left = drawn.filter((s) => lengths[lineOf(s)] >= shortest);
  return yield* asPhase(writtenOf(ends, segments, left, first, second, grid), 0.6, 1);
}

/** The segments that are drawn, and the line of each end. Yields its progress. */
function* drawnOf(
  ends: Float64Array,
  segments: readonly number[],
  joined: Uint32Array,
  first: MeetingMesh,
  second: MeetingMesh,
  diagonal: number,
): Generator<number, { drawn: number[]; lines: Uint32Array }, void> {
  const lines = disjointSets(joined.length);
  const drawn: number[] = [];
  for (let s = 0; s < segments.length; s += SEGMENT) {
    if (s % (SEGMENT * CHUNK) === 0 && s > 0) yield s / segments.length;
    const [i, j, a, b] = [segments[s], segments[s + 1], segments[s + 2], segments[s + 3]];
    const length = lengthOf(ends, segments, s);
    if (length === 0 || length < SHORTEST * diagonal) continue;
    if (areNearlyParallel(first, a, second, b, ends, 3 * i, 3 * j)) continue;
    if (isBesideLine(first, a, ends, 3 * i, 3 * j, BESIDE_EDGE * diagonal)) continue;
    if (isBesideLine(second, b, ends, 3 * i, 3 * j, BESIDE_EDGE * diagonal)) continue;
    drawn.push(s);
    join(lines, rootOf(joined, i), rootOf(joined, j));
  }
  return { drawn, lines };
}

/** `LINE_FLOATS` numbers for each of some segments. Yields its progress. */
function* writtenOf(
  ends: Float64Array,
  segments: readonly number[],
  left: readonly number[],
  first: MeetingMesh,
  second: MeetingMesh,
  { origin, step }: Grid,
): Generator<number, Float64Array<ArrayBuffer>, void> {
  const written = new Float64Array(LINE_FLOATS * left.length);
  for (let i = 0; i < left.length; i++) {
    if (i % CHUNK === CHUNK - 1) yield i / left.length;
    const s = left[i];
    const a = segments[s + 2];
    const b = segments[s + 3];
    let from = 3 * segments[s];
    let to = 3 * segments[s + 1];
    writeFaceNormal(first, a, faceA);
    writeFaceNormal(second, b, faceB);
    if (alongCrossed(faceA, faceB, ends, from, to) > 0) [from, to] = [to, from];
    const o = LINE_FLOATS * i;
    for (let axis = 0; axis < 3; axis++) {
      written[o + axis] = origin[axis] + step * ends[from + axis];
      written[o + 3 + axis] = origin[axis] + step * ends[to + axis];
    }
    writeNormal(first, a, faceA, ends[from], ends[from + 1], ends[from + 2], written, o + 6);
    writeNormal(first, a, faceA, ends[to], ends[to + 1], ends[to + 2], written, o + 9);
    writeNormal(second, b, faceB, ends[from], ends[from + 1], ends[from + 2], written, o + 12);
    writeNormal(second, b, faceB, ends[to], ends[to + 1], ends[to + 2], written, o + 15);
  }
  return written;
}

/** Normals of the two faces at a segment, and of their smooth surfaces: no vector is allocated for a segment. */
const faceA = new Float64Array(3);
const faceB = new Float64Array(3);
const smoothA = new Float64Array(3);
const smoothB = new Float64Array(3);

function lengthOf(ends: Float64Array, segments: readonly number[], s: number): number {
  const from = 3 * segments[s];
  const to = 3 * segments[s + 1];
  return Math.sqrt(
    (ends[from] - ends[to]) ** 2 + (ends[from + 1] - ends[to + 1]) ** 2 + (ends[from + 2] - ends[to + 2]) ** 2,
  );
}

/** (a × b) · (to − from). */
const alongCrossed = (a: Float64Array, b: Float64Array, ends: Float64Array, from: number, to: number): number =>
  (a[1] * b[2] - a[2] * b[1]) * (ends[to] - ends[from]) +
  (a[2] * b[0] - a[0] * b[2]) * (ends[to + 1] - ends[from + 1]) +
  (a[0] * b[1] - a[1] * b[0]) * (ends[to + 2] - ends[from + 2]);

/** The square of the sine of the angle between unit vectors. */
const squaredSine = (a: Float64Array, b: Float64Array): number =>
  (a[1] * b[2] - a[2] * b[1]) ** 2 + (a[2] * b[0] - a[0] * b[2]) ** 2 + (a[0] * b[1] - a[1] * b[0]) ** 2;

/** Writes a vector of length 1, or one without a direction as it is. */
function writeUnit(x: number, y: number, z: number, into: Float64Array, at: number): void {
  const length = Math.sqrt(x * x + y * y + z * z) || 1;
  into[at] = x / length;
  into[at + 1] = y / length;
  into[at + 2] = z / length;
}

function writeFaceNormal({ vertices, places: p }: MeetingMesh, triangle: number, into: Float64Array): void {
  const a = 3 * vertices[3 * triangle];
  const b = 3 * vertices[3 * triangle + 1];
  const c = 3 * vertices[3 * triangle + 2];
  const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
  const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
  writeUnit(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, into, 0);
}

/** Writes the smooth normal of a triangle at a place on it. @param face the unit normal of the triangle */
function writeNormal(
  { vertices, places: p, points, normals }: MeetingMesh,
  triangle: number,
  face: Float64Array,
  x: number,
  y: number,
  z: number,
  into: Float64Array,
  at: number,
): void {
  let sumX = 0;
  let sumY = 0;
  let sumZ = 0;
  for (let k = 0; k < 3; k++) {
    const b = 3 * vertices[3 * triangle + ((k + 1) % 3)];
    const c = 3 * vertices[3 * triangle + ((k + 2) % 3)];
    const [ux, uy, uz] = [p[b] - x, p[b + 1] - y, p[b + 2] - z];
    const [vx, vy, vz] = [p[c] - x, p[c + 1] - y, p[c + 2] - z];
    const area = (uy * vz - uz * vy) * face[0] + (uz * vx - ux * vz) * face[1] + (ux * vy - uy * vx) * face[2];
    const share = Math.max(area, 0);
    const n = 3 * points[3 * triangle + k];
    sumX += share * normals[n];
    sumY += share * normals[n + 1];
    sumZ += share * normals[n + 2];
  }
  if (sumX !== 0 || sumY !== 0 || sumZ !== 0) writeUnit(sumX, sumY, sumZ, into, at);
  else into.set(face, at);
}

/** Whether two surfaces nearly touch at a segment: by their faces, or by their smooth normals in its middle. */
function areNearlyParallel(
  first: MeetingMesh,
  a: number,
  second: MeetingMesh,
  b: number,
  ends: Float64Array,
  from: number,
  to: number,
): boolean {
  writeFaceNormal(first, a, faceA);
  writeFaceNormal(second, b, faceB);
  if (squaredSine(faceA, faceB) < LEAST_FACE_SINE ** 2) return true;
  const x = (ends[from] + ends[to]) / 2;
  const y = (ends[from + 1] + ends[to + 1]) / 2;
  const z = (ends[from + 2] + ends[to + 2]) / 2;
  writeNormal(first, a, faceA, x, y, z, smoothA, 0);
  writeNormal(second, b, faceB, x, y, z, smoothB, 0);
  return squaredSine(smoothA, smoothB) < LEAST_SINE ** 2;
}

/** Whether both ends of a segment lie beside one edge of a triangle that has a line already. */
function isBesideLine(
  mesh: MeetingMesh,
  triangle: number,
  ends: Float64Array,
  from: number,
  to: number,
  distance: number,
): boolean {
  for (let k = 0; k < 3; k++) {
    if (!mesh.hasLine(triangle, k)) continue;
    const start = 3 * mesh.vertices[3 * triangle + k];
    const end = 3 * mesh.vertices[3 * triangle + ((k + 1) % 3)];
    const p = mesh.places;
    if (distanceTo(p, start, end, ends, from) < distance && distanceTo(p, start, end, ends, to) < distance) return true;
  }
  return false;
}

/** The distance of an end from an edge. */
function distanceTo(p: Float64Array, start: number, end: number, ends: Float64Array, i: number): number {
  const [x, y, z] = [p[end] - p[start], p[end + 1] - p[start + 1], p[end + 2] - p[start + 2]];
  const [dx, dy, dz] = [ends[i] - p[start], ends[i + 1] - p[start + 1], ends[i + 2] - p[start + 2]];
  const share = Math.min(Math.max((x * dx + y * dy + z * dz) / (x * x + y * y + z * z), 0), 1);
  return Math.sqrt((dx - share * x) ** 2 + (dy - share * y) ** 2 + (dz - share * z) ** 2);
}
