import {
  BoxGeometry,
  CircleGeometry,
  CylinderGeometry,
  Euler,
  Matrix4,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { findIntersections } from '../../../../src/mesh/intersections/findIntersections.js';
import type { IntersectingMesh } from '../../../../src/mesh/intersections/MeetingMesh.js';
import { runToEnd } from '../../../../src/mesh/phases.js';
import { endsAt, lengthOf, meetingMesh, segmentsIn, slicedLength } from './meshes.js';

const at = (x: number, y: number, z: number, turn = new Euler()): Matrix4 =>
  new Matrix4().compose(new Vector3(x, y, z), new Quaternion().setFromEuler(turn), new Vector3(1, 1, 1));

const linesOf = (...meshes: IntersectingMesh[]) =>
  runToEnd(findIntersections({ meshes })).map(({ first, second, lines }) => ({
    first,
    second,
    segments: segmentsIn(lines!),
  }));

const segmentsOf = (...meshes: IntersectingMesh[]) => linesOf(...meshes).flatMap(({ segments }) => segments);

const box = new BoxGeometry(2, 2, 2);
const boxEdges = (place?: Matrix4) => {
  const mesh = meetingMesh(box, place);
  // The sides of each quadrilateral, and not its diagonal.
  const edges = Array.from({ length: 6 }, (_, i) => [0, 1, 1, 3, 3, 2, 2, 0].map((k) => 4 * i + k)).flat();
  return { ...mesh, edges: Uint32Array.from(edges) };
};

describe('lines where two parts meet', () => {
  test('a ball that runs into a box: as long as its triangles cut one by one', () => {
    const ball = new SphereGeometry(0.7, 64, 32);
    const place = at(1.3, 0.15, -0.2, new Euler(0.3, 0.8, 0.2));
    const found = segmentsOf(boxEdges(), meetingMesh(ball, place));
    const right = slicedLength(ball, place, 1, 1);
    expect(lengthOf(found)).toBeGreaterThan(0.999 * right);
    expect(lengthOf(found)).toBeLessThan(1.001 * right);
    expect(endsAt(found).every((count) => count === 2)).toBe(true);
  });

  test('a ball that looks out of a box on all its sides: six circles', () => {
    const ball = new SphereGeometry(1.2, 256, 128);
    const found = segmentsOf(boxEdges(), meetingMesh(ball, at(0, 0, 0, new Euler(0.4, 0.5, 0.6))));
    const right = 6 * 2 * Math.PI * Math.sqrt(1.2 ** 2 - 1);
    expect(Math.abs(lengthOf(found) / right - 1)).toBeLessThan(1e-3);
  });

  test('a rod through a ball: two circles', () => {
    const rod = meetingMesh(new CylinderGeometry(0.4, 0.4, 4, 256, 1), at(0.01, 0, 0.02));
    const ball = meetingMesh(new SphereGeometry(1, 256, 128), at(0, 0, 0, new Euler(0.5, 0.1, 0.3)));
    const found = segmentsOf(rod, ball);
    expect(Math.abs(lengthOf(found) / (2 * 2 * Math.PI * 0.4) - 1)).toBeLessThan(1e-3);
    expect(endsAt(found).every((count) => count === 2)).toBe(true);
  });

  test('a torus in a torus, turned at random: every end belongs to two segments', () => {
    for (let seed = 0; seed < 12; seed++) {
      const turn = new Euler(seed, 2.1 * seed, 0.7 * seed);
      const found = segmentsOf(
        meetingMesh(new TorusGeometry(1, 0.3, 24, 48)),
        meetingMesh(new TorusGeometry(1, 0.35, 20, 40), at(0.5 + 0.03 * seed, 0.1, 0, turn)),
      );
      expect(found.length).toBeGreaterThan(20);
      // Nearly parallel surfaces have no line, so a line may end there.
      const odd = endsAt(found).filter((count) => count !== 2);
      expect(odd.length).toBeLessThanOrEqual(8);
    }
  });

  test('grids whose vertices lie on each other’s edges and planes: closed lines all the same', () => {
    const block = new BoxGeometry(2, 2, 2, 4, 4, 4);
    for (const [x, y, z] of [
      [1, 0.5, 0.5],
      [0.5, 0.5, 0.5],
      [1, 1, 0.25],
    ]) {
      const found = segmentsOf(meetingMesh(block), meetingMesh(block, at(x, y, z)));
      expect(endsAt(found).every((count) => count % 2 === 0)).toBe(true);
    }
    // The edges of their common box that are edges of neither.
    const found = segmentsOf(meetingMesh(block), meetingMesh(block, at(1, 0.5, 0.25)));
    expect(lengthOf(found)).toBeCloseTo(2 * 1.75 + 2 * 1.5 + 2 * 1, 6);
  });

  test('a line through vertices that both meshes have: no gap there', () => {
    const origin = new Vector3();
    const star = (turn: Euler) => {
      // Six triangles about the origin, which lie in one plane.
      const disk = new CircleGeometry(1, 6).applyMatrix4(at(0, 0, 0, turn));
      disk.attributes.position.setXYZ(0, 0, 0, 0);
      return meetingMesh(disk);
    };
    for (const turn of [new Euler(1.2, 0.1, 0.4), new Euler(0.7, 0.5, 0.05)]) {
      const found = segmentsOf(star(new Euler(0, 0, 0.2)), star(turn));
      const ends = found.filter(({ from, to }) => from.distanceTo(origin) < 1e-6 || to.distanceTo(origin) < 1e-6);
      expect(ends).toHaveLength(2);
      // Both disks are hexagons, so that the line is as long as the shorter of two chords.
      expect(lengthOf(found)).toBeGreaterThan(2 * Math.cos(Math.PI / 6) - 1e-6);
      expect(lengthOf(found)).toBeLessThan(2);
      expect(endsAt(found).filter((count) => count !== 2)).toHaveLength(2);
    }
  });

  test('the surfaces of a segment form a valley', () => {
    const request = { meshes: [boxEdges(), meetingMesh(new SphereGeometry(1, 32, 16), at(1.3, 0, 0))] };
    const [{ lines }] = runToEnd(findIntersections(request));
    for (let i = 0; i < lines!.length; i += 18) {
      const [from, to, first, , second] = [0, 3, 6, 9, 12].map((o) => new Vector3().fromArray(lines!, i + o));
      expect(first.cross(second).dot(to.sub(from))).toBeLessThan(0);
    }
  });

  test('shells of one mesh', () => {
    const merged = mergeGeometries([
      new SphereGeometry(1, 128, 64),
      new CylinderGeometry(0.4, 0.4, 4, 128, 1).applyMatrix4(at(0.01, 0, 0.02)),
    ]);
    const found = linesOf(meetingMesh(merged));
    expect(found.map(({ first, second }) => [first, second])).toEqual([[0, 0]]);
    expect(Math.abs(lengthOf(found[0].segments) / (2 * 2 * Math.PI * 0.4) - 1)).toBeLessThan(2e-3);
  });

  test('pairs that are asked for alone', () => {
    const meshes = [0, 1.3, 2.6].map((x) => meetingMesh(new SphereGeometry(1, 32, 16), at(x, 0, 0)));
    expect(linesOf(...meshes).map(({ first, second }) => [first, second])).toEqual([
      [0, 1],
      [1, 2],
    ]);
    const some = runToEnd(findIntersections({ meshes, pairs: [1, 2] }));
    expect(some.map(({ first, second }) => [first, second])).toEqual([[1, 2]]);
  });
});

describe('what is no line', () => {
  test('sheets that nearly touch, flat and curved', () => {
    const sheet = (seed: number) => {
      const plane = new PlaneGeometry(4, 4, 40, 40);
      const { position } = plane.attributes;
      for (let i = 0; i < position.count; i++)
        position.setZ(i, 0.3 * Math.sin(position.getX(i)) + 1e-3 * Math.sin(7 * i * seed + seed));
      plane.computeVertexNormals();
      return meetingMesh(plane);
    };
    expect(segmentsOf(sheet(1), sheet(2))).toEqual([]);
    const tilted = meetingMesh(new PlaneGeometry(1, 1), at(0, 0, 0, new Euler(0.05, 0, 0)));
    expect(segmentsOf(meetingMesh(new PlaneGeometry(2, 2)), tilted)).toEqual([]);
  });

  test('a ball doubled with other triangles', () => {
    const one = meetingMesh(new SphereGeometry(1, 32, 16));
    const other = meetingMesh(new SphereGeometry(1, 40, 24), at(0, 0, 0, new Euler(1, 2, 3)));
    expect(segmentsOf(one, other)).toEqual([]);
  });

  test('the same mesh twice', () => {
    const ball = () => meetingMesh(new SphereGeometry(1, 32, 16));
    expect(segmentsOf(ball(), ball(), ball())).toEqual([]);
    expect(segmentsOf(boxEdges(), boxEdges())).toEqual([]);
  });

  test('a box that stands on another or beside it, whose edges have lines already', () => {
    for (const [x, y, z] of [
      [0.3, 2, 0.2],
      [2, 0, 0],
      [2, 1e-5, 0.3],
      [0.3, 2 - 1e-4, 0.2],
    ])
      expect(segmentsOf(boxEdges(), boxEdges(at(x, y, z)))).toEqual([]);
  });

  test('parts that share the vertices of a seam', () => {
    const tube = new CylinderGeometry(1, 1, 2, 48, 4, true);
    const cap = new SphereGeometry(1, 48, 16, 0, 2 * Math.PI, 0, Math.PI / 2).translate(0, 1, 0);
    expect(segmentsOf(meetingMesh(tube), meetingMesh(cap))).toEqual([]);
  });
});

describe('bad input', () => {
  test('NaN, infinite numbers, triangles without area, nothing at all', () => {
    const good = meetingMesh(new SphereGeometry(1, 16, 8));
    const broken = meetingMesh(new SphereGeometry(1, 16, 8), at(1, 0, 0));
    for (let i = 0; i < broken.positions.length; i += 7) broken.positions[i] = i % 2 ? Number.NaN : Infinity;
    const flat = { ...meetingMesh(new SphereGeometry(1, 16, 8)), toShared: new Matrix4().makeScale(0, 1, 1).elements };
    const empty = { ...good, triangles: new Uint32Array(0) };
    const nowhere = { ...good, positions: good.positions.map(() => Number.NaN) };
    for (const mesh of [broken, flat, empty, nowhere])
      for (const { from, to } of segmentsOf(good, mesh))
        expect([...from.toArray(), ...to.toArray()].every(Number.isFinite)).toBe(true);
    expect(segmentsOf()).toEqual([]);
  });

  test('too much work ends with null, and 5,000 parts do not take long to look through', { tags: ['all'] }, () => {
    const steps = (meshes: IntersectingMesh[]) => runToEnd(findIntersections({ meshes }));
    const hedgehog = new SphereGeometry(1, 96, 48);
    const { position } = hedgehog.attributes;
    for (let i = 0; i < position.count; i++) if (i % 2) position.setXYZ(i, 1e-3 * i, 0, 0);
    const crossed = Array.from({ length: 40 }, (_, i) => meetingMesh(hedgehog, at(0, 0, 0, new Euler(i, 2 * i, 0))));
    const lines = steps(crossed);
    expect(lines.length).toBeGreaterThan(100);
    expect(lines[lines.length - 1].lines).toBe(null);
    const tiny = Array.from({ length: 5000 }, (_, i) =>
      meetingMesh(new BoxGeometry(0.01, 0.01, 0.01), at(Math.sin(i), Math.sin(2.3 * i), Math.sin(3.7 * i))),
    );
    expect(steps(tiny).every((one) => one.lines !== null)).toBe(true);
  });
});
