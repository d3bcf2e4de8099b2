import {
  BufferAttribute,
  type BufferGeometry,
  type Material,
  type Mesh,
  MeshPhongMaterial,
  type Object3D,
} from 'three';
import { TDSLoader } from 'three/addons/loaders/TDSLoader.js';
import { ModelError } from '../common/ModelError.js';
import { withFakeDocument } from './fakeDocument.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';

/** Reads a 3DS file. @throws ModelError if it is damaged; Error of the loader */
export function read3ds(bytes: Uint8Array, name: string): LoadedScene {
  const plain = bytes.slice();
  check3ds(plain, name);
  const loader = new TdsFaces();
  const root = withFakeDocument(() => loader.parse(plain.buffer, ''));
  root?.traverse((object) => setNormals(object, loader));
  return sceneOf(root, name);
}

/**
 * Gives a mesh the normals of its smoothing groups, or none: the loader's are smooth across every edge, and missing ones are computed later
 * with creases kept.
 */
function setNormals(object: Object3D, { smoothing }: TdsFaces): void {
  const mesh = object as Mesh;
  const groups = smoothing.get(mesh.geometry);
  if (groups) mesh.geometry = smoothByGroups(mesh.geometry, groups);
  else (object as Partial<Mesh>).geometry?.deleteAttribute('normal');
}

const HEADER_BYTES = 6;
/** Chunks that contain chunks: the file, its models, a material, its pictures, a mesh. */
const CONTAINERS = new Set([0x4d4d, 0x3d3d, 0xafff, 0xa200, 0xa204, 0xa210, 0xa230, 0x4100]);
const OBJECT = 0x4000;
const HIDDEN = 0x4010;
const FACES = 0x4120;
const AXES = 0x4160;
const AMBIENT = 0xa010;
/** An id that three's loader skips. */
const UNREAD = 0x3fff;
/** The local axes of a mesh: identity, or with x mirrored. */
const [SAME, MIRRORED] = [1, -1].map((x) => [x, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);

/**
 * Checks that every chunk of a 3DS file has a length and lies within its parent; three's loader would loop forever on a chunk of length 0.
 * Also hides data in the bytes that the loader misreads: hidden objects, the ambient colour, which it takes for the surface colour, and the
 * axes of meshes, whose points are in world space already. Of the axes only mirroring is kept.
 *
 * @throws ModelError
 */
function check3ds(bytes: Uint8Array, name: string): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const pending = [{ start: 0, end: bytes.length, parent: 0, isObject: false }];
  for (let range = pending.pop(); range; range = pending.pop()) {
    for (let at = range.start; at + HEADER_BYTES <= range.end; ) {
      const id = view.getUint16(at, true);
      const end = at + view.getUint32(at + 2, true);
      if (end < at + HEADER_BYTES || end > range.end) {
        throw new ModelError(`${name} is damaged or cut short: one of its parts has a wrong length.`);
      }
      const start = firstChild(bytes, view, id, at + HEADER_BYTES, end);
      if (start !== undefined) pending.push({ start, end, parent: at, isObject: id === OBJECT });
      if (id === AMBIENT) view.setUint16(at, UNREAD, true);
      else if (id === HIDDEN && range.isObject) view.setUint16(range.parent, UNREAD, true);
      else if (id === AXES) plainAxes(view, at + HEADER_BYTES, end);
      at = end;
    }
  }
}

/** Replaces axes by those of the world. */
function plainAxes(view: DataView, at: number, end: number): void {
  if (at + 4 * SAME.length > end) return;
  const [ax, ay, az, bx, by, bz, cx, cy, cz] = SAME.map((_, i) => view.getFloat32(at + 4 * i, true));
  const turn = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  for (const [i, value] of (turn < 0 ? MIRRORED : SAME).entries()) view.setFloat32(at + 4 * i, value, true);
}

/** The offset of the first chunk within a chunk; undefined if it has none. */
function firstChild(bytes: Uint8Array, view: DataView, id: number, at: number, end: number): number | undefined {
  if (CONTAINERS.has(id)) return at;
  if (id === OBJECT) {
    const nameEnd = bytes.indexOf(0, at);
    return nameEnd === -1 || nameEnd >= end ? undefined : nameEnd + 1;
  }
  return id === FACES && at + 2 <= end ? at + 2 + 8 * view.getUint16(at, true) : undefined;
}

/** A chunk of a file, as three's loader represents it. */
interface Chunk {
  readonly id: number;
  readonly endOfChunk: boolean;
  readWord(): number;
  readDWord(): number;
  readString(): string;
  readChunk(): Chunk | null;
}

const MATERIAL_GROUP = 0x4130;
const SMOOTHING = 0x4150;

/**
 * three's loader for 3DS with its handling of faces corrected: it assigns materials to faces by position instead of index, drops faces
 * without a material, and ignores smoothing groups.
 */
class TdsFaces extends TDSLoader {
  /** The smoothing groups of triangles, where the file has them: one bit per group. */
  readonly smoothing = new Map<BufferGeometry, Uint32Array>();

  /** @param part actually a {@link Chunk} */
  override readFaceArray(part: DataView, mesh: Mesh): void {
    const chunk = part as unknown as Chunk;
    const count = chunk.readWord();
    const corners: number[][] = [];
    for (let face = 0; face < count; face++) {
      corners.push([chunk.readWord(), chunk.readWord(), chunk.readWord()]);
      // The visibility of edges, which is not used.
      chunk.readWord();
    }
    const groups = new Map<string, number[]>();
    const isNamed = new Uint8Array(count);
    let smoothing: number[] | undefined;
    for (let next = nextOf(chunk); next; next = nextOf(chunk)) {
      if (next.id === SMOOTHING) smoothing = corners.map(() => next!.readDWord());
      if (next.id !== MATERIAL_GROUP) continue;
      const name = next.readString();
      const faces = groups.get(name) ?? [];
      groups.set(name, faces);
      for (let left = next.readWord(); left > 0; left--) {
        const face = next.readWord();
        if (!(face < count) || isNamed[face]) continue;
        isNamed[face] = 1;
        faces.push(face);
      }
    }
    const known = this.materials as unknown as Readonly<Record<string, Material | undefined>>;
    const others = corners.flatMap((_, face) => (isNamed[face] ? [] : [face]));
    const sorted: number[] = [];
    const materials: Material[] = [];
    for (const [name, faces] of [...groups, ['', others] as const]) {
      if (faces.length === 0) continue;
      mesh.geometry.addGroup(3 * sorted.length, 3 * faces.length, materials.length);
      materials.push(known[name] ?? new MeshPhongMaterial());
      sorted.push(...faces);
    }
    mesh.geometry.setIndex(sorted.flatMap((face) => corners[face]));
    mesh.material = materials.length === 1 ? materials[0] : materials;
    if (smoothing) {
      const given = smoothing;
      this.smoothing.set(
        mesh.geometry,
        Uint32Array.from(sorted, (face) => given[face]),
      );
    }
  }
}

const nextOf = (chunk: Chunk): Chunk | null => (chunk.endOfChunk ? null : chunk.readChunk());

/** The sum of face normals around a point for one set of smoothing groups. */
interface Sum {
  groups: number;
  normal: [x: number, y: number, z: number];
}

/**
 * Returns a geometry without an index, with normals by smoothing groups: each corner has the angle-weighted mean of adjacent faces that
 * share a group with its own face. Faces without a group are flat. Points at one place count as one, since texture seams split them.
 *
 * @param groups per triangle, one bit per group
 */
function smoothByGroups(geometry: BufferGeometry, groups: ArrayLike<number>): BufferGeometry {
  const smooth = geometry.index ? geometry.toNonIndexed() : geometry.clone();
  const { array: points } = smooth.getAttribute('position');
  const normals = new Float32Array(points.length);
  const around = new Map<string, Sum[]>();
  const placeOf = (corner: number): string => `${points[corner]} ${points[corner + 1]} ${points[corner + 2]}`;
  const face: [number, number, number] = [0, 0, 0];
  for (let at = 0; at + 9 <= points.length; at += 9) {
    faceNormal(points, at, face);
    normals.set(face, at);
    normals.set(face, at + 3);
    normals.set(face, at + 6);
    const own = groups[at / 9] ?? 0;
    if (own === 0) continue;
    for (let k = 0; k < 3; k++) {
      const weight = angleAt(points, at + 3 * k, at + 3 * ((k + 1) % 3), at + 3 * ((k + 2) % 3));
      const place = placeOf(at + 3 * k);
      const sums = around.get(place) ?? [];
      around.set(place, sums);
      const sum = sums.find((one) => one.groups === own) ?? { groups: own, normal: [0, 0, 0] };
      if (!sums.includes(sum)) sums.push(sum);
      for (let axis = 0; axis < 3; axis++) sum.normal[axis] += weight * face[axis];
    }
  }
  for (let at = 0; at + 3 <= points.length; at += 3) {
    const own = groups[Math.floor(at / 9)] ?? 0;
    if (own === 0) continue;
    const total: [number, number, number] = [0, 0, 0];
    for (const sum of around.get(placeOf(at)) ?? [])
      if ((sum.groups & own) !== 0) for (let axis = 0; axis < 3; axis++) total[axis] += sum.normal[axis];
    const length = Math.hypot(...total);
    for (let axis = 0; axis < 3; axis++) normals[at + axis] = length > 0 ? total[axis] / length : 0;
  }
  smooth.setAttribute('normal', new BufferAttribute(normals, 3));
  return smooth;
}

/** Writes the unit normal of a triangle; zero if it has no area. */
function faceNormal(points: ArrayLike<number>, at: number, normal: [number, number, number]): void {
  const [ux, uy, uz] = [3, 4, 5].map((k) => points[at + k] - points[at + k - 3]);
  const [vx, vy, vz] = [6, 7, 8].map((k) => points[at + k] - points[at + k - 6]);
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z);
  const scale = length > 0 && length < Infinity ? 1 / length : 0;
  normal[0] = scale * x || 0;
  normal[1] = scale * y || 0;
  normal[2] = scale * z || 0;
}

/** The angle of a triangle at its corner `o`. */
function angleAt(points: ArrayLike<number>, o: number, a: number, b: number): number {
  let [dot, lengthA, lengthB] = [0, 0, 0];
  for (let axis = 0; axis < 3; axis++) {
    const [u, v] = [points[a + axis] - points[o + axis], points[b + axis] - points[o + axis]];
    dot += u * v;
    lengthA += u * u;
    lengthB += v * v;
  }
  const cosine = dot / Math.sqrt(lengthA * lengthB);
  return cosine >= -1 && cosine <= 1 ? Math.acos(cosine) : 0;
}
