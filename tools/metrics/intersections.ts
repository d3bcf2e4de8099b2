import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  Euler,
  Matrix4,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';
import { findIntersections } from '../../src/mesh/intersections/findIntersections.js';
import { LINE_FLOATS } from '../../src/mesh/intersections/joinSegments.js';
import type { IntersectingMesh } from '../../src/mesh/intersections/MeetingMesh.js';

/** The lines along which parts of a scene cut each other, and how long it takes to find them. */
export interface IntersectionMeasure {
  scene: string;
  triangles: number;
  /** Pairs that have lines. */
  pairs: number;
  segments: number;
  /** Milliseconds in all, in the longest step, and for a pair. */
  time: number;
  longestStep: number;
  perPair: number;
  /** Length of all lines as a share of the right one; null where that is not known. */
  length: number | null;
}

/** Finds the lines of a rod through a ball, of 50 parts with some 100,000 triangles, and of 5,000 small boxes. */
export function measureIntersections(): IntersectionMeasure[] {
  const rod = part(new CylinderGeometry(0.4, 0.4, 4, 256, 1), new Matrix4().makeTranslation(0.01, 0, 0.02));
  const ball = part(new SphereGeometry(1, 256, 128), new Matrix4().makeRotationX(0.5));
  return [
    measured('a rod through a ball', [rod, ball], 2 * 2 * Math.PI * 0.4),
    measured('50 parts, far apart', crowd(50, 6), null),
    measured('50 parts, crowded', crowd(50, 3), null),
    measured('5,000 small boxes', boxes(5000, 60), null),
  ];
}

function measured(scene: string, meshes: IntersectingMesh[], right: number | null): IntersectionMeasure {
  const triangles = meshes.reduce((sum, mesh) => sum + mesh.triangles.length / 3, 0);
  const search = findIntersections({ meshes });
  const start = performance.now();
  let longestStep = 0;
  for (let last = start; ; ) {
    const step = search.next();
    const now = performance.now();
    longestStep = Math.max(longestStep, now - last);
    last = now;
    if (!step.done) continue;
    const lines = step.value.flatMap((one) => (one.lines ? [one.lines] : []));
    const segments = lines.reduce((sum, { length }) => sum + length / LINE_FLOATS, 0);
    const time = now - start;
    const length = right === null ? null : lines.reduce((sum, line) => sum + lengthOf(line), 0) / right;
    const pairs = lines.length;
    return { scene, triangles, pairs, segments, time, longestStep, perPair: time / Math.max(pairs, 1), length };
  }
}

function lengthOf(lines: Float64Array): number {
  let sum = 0;
  for (let o = 0; o < lines.length; o += LINE_FLOATS)
    sum += Math.hypot(lines[o] - lines[o + 3], lines[o + 1] - lines[o + 4], lines[o + 2] - lines[o + 5]);
  return sum;
}

function part(geometry: BufferGeometry, place: Matrix4): IntersectingMesh {
  const { position, normal } = geometry.attributes;
  return {
    positions: Float32Array.from(position.array),
    normals: Float32Array.from(normal.array),
    triangles: Uint32Array.from(geometry.index!.array),
    edges: new Uint32Array(0),
    toShared: [...place.elements],
  };
}

/** Numbers in [0, 1) that look random, the same in every run. */
function* shares(): Generator<number, number, void> {
  for (let state = 1; ; ) {
    state = (state * 16807) % 2147483647;
    yield state / 2147483647;
  }
}

/** A place in a cube of some size, turned at random. */
function placeIn(size: number, random: Generator<number, number, void>): Matrix4 {
  const next = () => random.next().value;
  const turn = new Quaternion().setFromEuler(new Euler(6 * next(), 6 * next(), 0));
  return new Matrix4().compose(new Vector3(size * next(), size * next(), size * next()), turn, new Vector3(1, 1, 1));
}

function crowd(count: number, size: number): IntersectingMesh[] {
  const random = shares();
  const kinds = [
    new SphereGeometry(0.6, 46, 23),
    new CylinderGeometry(0.3, 0.3, 2, 250, 2),
    new TorusGeometry(0.6, 0.2, 25, 40),
    new BoxGeometry(1, 1, 1, 13, 13, 13),
  ];
  return Array.from({ length: count }, (_, i) => part(kinds[i % kinds.length], placeIn(size, random)));
}

function boxes(count: number, size: number): IntersectingMesh[] {
  const random = shares();
  const box = new BoxGeometry(1, 1, 1);
  return Array.from({ length: count }, () => part(box, placeIn(size, random)));
}
