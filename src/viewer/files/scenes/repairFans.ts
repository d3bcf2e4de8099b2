import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute, Mesh, Object3D } from 'three';
import { triangulatePolygon } from '../mesh/triangulatePolygon.js';

/** The least cosine of the angle between coplanar triangles, in either direction. */
const SAME_PLANE = 0.999;

type Attribute = BufferAttribute | InterleavedBufferAttribute;
type Point = readonly [number, number, number];

/**
 * Retriangulates concave polygons that three's loaders have cut as fans: consecutive triangles that form a fan in one plane with
 * inconsistent winding.
 */
export function repairFans(root: Object3D): void {
  const seen = new Set<BufferGeometry>();
  root.traverse((object) => {
    const { geometry, isMesh } = object as Mesh;
    if (!isMesh || seen.has(geometry) || !geometry.getAttribute('position')) return;
    seen.add(geometry);
    repair(geometry);
  });
}

function repair(geometry: BufferGeometry): void {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const count = index?.count ?? position.count;
  const vertices = Uint32Array.from({ length: count - (count % 3) }, (_, corner) => index?.getX(corner) ?? corner);
  const pointOf = (vertex: number): Point => [position.getX(vertex), position.getY(vertex), position.getZ(vertex)];
  const mended: number[] = [];
  for (let corner = 0; corner < vertices.length; ) {
    const { polygon, turnsBack } = fanAt(vertices, corner, pointOf);
    const end = corner + 3 * (polygon.length - 2);
    if (turnsBack) {
      const triangles = triangulatePolygon(polygon.flatMap(pointOf));
      for (let k = corner; k < end; k++) vertices[k] = polygon[triangles[k - corner] ?? 0];
      mended.push(corner, end);
    }
    corner = end;
  }
  if (mended.length === 0) return;
  if (index) geometry.setIndex([...vertices]);
  else rearrange(geometry, vertices);
  for (let i = 0; i < mended.length; i += 2) turnNormals(geometry, mended[i], mended[i + 1]);
}

/** The outline of a fan of triangles, and whether one of them has the opposite winding. */
interface Fan {
  polygon: number[];
  turnsBack: boolean;
}

/**
 * The longest coplanar fan that begins with a triangle: around its first corner or, of two triangles, around the corner that they share
 * last.
 */
function fanAt(vertices: Uint32Array, first: number, pointOf: (vertex: number) => Point): Fan {
  const triangle = (at: number): [number, number, number] => [vertices[at], vertices[at + 1], vertices[at + 2]];
  const areSame = (a: number, b: number): boolean => a === b || pointOf(a).every((value, k) => value === pointOf(b)[k]);
  const [a, b, c] = triangle(first);
  const normals = [normalOf(pointOf(a), pointOf(b), pointOf(c))];
  const polygon = [a, b, c];
  // Two halves of a quad split from its second to its last corner.
  const isHalf = (next: readonly number[]): boolean =>
    areSame(next[0], b) && areSame(next[2], c) && !areSame(next[1], a);
  for (let at = first + 3; at < vertices.length; at += 3) {
    const next = triangle(at);
    const normal = normalOf(...(next.map(pointOf) as [Point, Point, Point]));
    if (!areInPlane(normals[0], normal)) break;
    if (at === first + 3 && isHalf(next)) {
      normals.push(normal);
      polygon.splice(2, 0, next[1]);
      break;
    }
    const isForward = areSame(next[1], polygon[polygon.length - 1]);
    const isBackward = areSame(next[2], polygon[1]);
    if (!areSame(next[0], a) || !(isForward || isBackward)) break;
    normals.push(normal);
    if (isForward) polygon.push(next[2]);
    else polygon.splice(1, 0, next[1]);
  }
  const whole = [0, 1, 2].map((axis) => normals.reduce((sum, normal) => sum + normal[axis], 0));
  const turnsBack = normals.some((normal) => normal[0] * whole[0] + normal[1] * whole[1] + normal[2] * whole[2] < 0);
  return { polygon, turnsBack };
}

/** Twice the area of a triangle times its normal. */
function normalOf([ax, ay, az]: Point, [bx, by, bz]: Point, [cx, cy, cz]: Point): Point {
  const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

const areInPlane = (a: Point, b: Point): boolean =>
  Math.abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) >= SAME_PLANE * Math.hypot(...a) * Math.hypot(...b);

/** Copies vertices of a geometry without an index in a new order. */
function rearrange({ attributes, morphAttributes }: BufferGeometry, vertices: Uint32Array): void {
  for (const attribute of [...Object.values(attributes), ...Object.values(morphAttributes).flat()] as Attribute[]) {
    const { itemSize } = attribute;
    const former = attribute.clone();
    for (let corner = 0; corner < vertices.length; corner++)
      for (let k = 0; k < itemSize; k++) attribute.setComponent(corner, k, former.getComponent(vertices[corner], k));
  }
}

/** Flips the normals of corners that point to the back of their triangle: they were computed for the fan. */
function turnNormals({ index, attributes }: BufferGeometry, first: number, end: number): void {
  const { position, normal } = attributes;
  if (!normal) return;
  const at = (attribute: Attribute, vertex: number): Point => [
    attribute.getX(vertex),
    attribute.getY(vertex),
    attribute.getZ(vertex),
  ];
  for (let corner = first; corner < end; corner += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => index?.getX(corner + k) ?? corner + k);
    const face = normalOf(at(position, a), at(position, b), at(position, c));
    for (const vertex of [a, b, c]) {
      const [x, y, z] = at(normal, vertex);
      if (x * face[0] + y * face[1] + z * face[2] < 0) normal.setXYZ(vertex, -x, -y, -z);
    }
  }
}
