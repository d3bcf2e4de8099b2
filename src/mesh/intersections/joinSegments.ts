import { disjointSets, join, rootOf } from '../disjointSets.js';
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

type Vector = [x: number, y: number, z: number];

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
  { origin, step }: Grid,
): Generator<number, Float64Array<ArrayBuffer>, void> {
  const ends = Float64Array.from(places);
  const endAt = (i: number): Vector => [ends[3 * i], ends[3 * i + 1], ends[3 * i + 2]];
  const lengthOf = (s: number): number => Math.hypot(...minus(endAt(segments[s]), endAt(segments[s + 1])));
  const joined = disjointSets(ends.length / 3);
  const shortest = SHORTEST * diagonal;
  const kept: number[] = [];
  for (let s = 0; s < segments.length; s += SEGMENT) {
    if (lengthOf(s) < shortest) join(joined, segments[s], segments[s + 1]);
    else kept.push(s);
  }
  // Ends that were joined are where the first of them is, so that lines stay in one piece.
  for (let i = 0; i < joined.length; i++) {
    const root = rootOf(joined, i);
    if (root !== i) for (let axis = 0; axis < 3; axis++) ends[3 * i + axis] = ends[3 * root + axis];
  }
  yield 0.1;
  const lines = disjointSets(joined.length);
  const drawn: number[] = [];
  for (const [i, s] of kept.entries()) {
    if (i % CHUNK === CHUNK - 1) yield 0.1 + (0.5 * i) / kept.length;
    const [from, to] = [endAt(segments[s]), endAt(segments[s + 1])];
    const [a, b] = [segments[s + 2], segments[s + 3]];
    if (areNearlyParallel(first, a, second, b, middleOf(from, to))) continue;
    if (isBesideLine(first, a, from, to, BESIDE_EDGE * diagonal)) continue;
    if (isBesideLine(second, b, from, to, BESIDE_EDGE * diagonal)) continue;
    drawn.push(s);
    join(lines, rootOf(joined, segments[s]), rootOf(joined, segments[s + 1]));
  }
  const lengths = new Float64Array(joined.length);
  const lineOf = (s: number): number => rootOf(lines, rootOf(joined, segments[s]));
  for (const s of drawn) lengths[lineOf(s)] += lengthOf(s);
  const left = drawn.filter((s) => lengths[lineOf(s)] >= shortest);
  const written = new Float64Array(LINE_FLOATS * left.length);
  for (const [i, s] of left.entries()) {
    if (i % CHUNK === CHUNK - 1) yield 0.6 + (0.4 * i) / left.length;
    const [a, b] = [segments[s + 2], segments[s + 3]];
    let [from, to] = [endAt(segments[s]), endAt(segments[s + 1])];
    const along = crossed(faceNormal(first, a), faceNormal(second, b));
    if (dot(along, minus(to, from)) > 0) [from, to] = [to, from];
    const [start, end] = [from, to].map((place) => place.map((value, axis) => origin[axis] + step * value));
    const normals = [
      normalIn(first, a, from),
      normalIn(first, a, to),
      normalIn(second, b, from),
      normalIn(second, b, to),
    ];
    written.set([...start, ...end, ...normals.flat()], LINE_FLOATS * i);
  }
  return written;
}

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const middleOf = (a: Vector, b: Vector): Vector => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];

const crossed = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function unit(a: Vector): Vector {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
}

const cornerAt = ({ vertices, places }: MeetingMesh, triangle: number, k: number): Vector => {
  const o = 3 * vertices[3 * triangle + (k % 3)];
  return [places[o], places[o + 1], places[o + 2]];
};

function faceNormal(mesh: MeetingMesh, triangle: number): Vector {
  const origin = cornerAt(mesh, triangle, 0);
  return unit(crossed(minus(cornerAt(mesh, triangle, 1), origin), minus(cornerAt(mesh, triangle, 2), origin)));
}

/** The smooth normal of a triangle at a place on it. */
function normalIn(mesh: MeetingMesh, triangle: number, place: Vector): Vector {
  const face = faceNormal(mesh, triangle);
  const sum: Vector = [0, 0, 0];
  for (let k = 0; k < 3; k++) {
    const [next, last] = [cornerAt(mesh, triangle, k + 1), cornerAt(mesh, triangle, k + 2)];
    const share = Math.max(dot(crossed(minus(next, place), minus(last, place)), face), 0);
    const o = 3 * mesh.points[3 * triangle + k];
    for (let axis = 0; axis < 3; axis++) sum[axis] += share * mesh.normals[o + axis];
  }
  return dot(sum, sum) > 0 ? unit(sum) : face;
}

function areNearlyParallel(first: MeetingMesh, a: number, second: MeetingMesh, b: number, place: Vector): boolean {
  const sine = Math.hypot(...crossed(normalIn(first, a, place), normalIn(second, b, place)));
  return sine < LEAST_SINE || Math.hypot(...crossed(faceNormal(first, a), faceNormal(second, b))) < LEAST_FACE_SINE;
}

/** Whether both ends of a segment lie beside one edge of a triangle that has a line already. */
function isBesideLine(mesh: MeetingMesh, triangle: number, from: Vector, to: Vector, distance: number): boolean {
  for (let k = 0; k < 3; k++) {
    if (!mesh.hasLine(triangle, k)) continue;
    const [start, end] = [cornerAt(mesh, triangle, k), cornerAt(mesh, triangle, k + 1)];
    if (distanceTo(start, end, from) < distance && distanceTo(start, end, to) < distance) return true;
  }
  return false;
}

function distanceTo(start: Vector, end: Vector, place: Vector): number {
  const [along, away] = [minus(end, start), minus(place, start)];
  const share = Math.min(Math.max(dot(along, away) / dot(along, along), 0), 1);
  return Math.hypot(away[0] - share * along[0], away[1] - share * along[1], away[2] - share * along[2]);
}
