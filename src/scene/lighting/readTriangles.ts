import {
  BackSide,
  type Camera,
  DoubleSide,
  type InstancedMesh,
  Matrix4,
  type Mesh,
  type Object3D,
  Vector3,
} from 'three';
import { openToLamps } from '../../material/exposure/openToLamps.js';
import { hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import { occlusionOf } from '../../mesh/occlusion/occlusionSides.js';
import { isBatched, isHatching, isSurfaceMesh, materialsOf } from '../surfaceMeshes.js';

/** The greatest number of triangles that are read. In larger scenes, each stands for some of its neighbours. */
const MAX_TRIANGLES = 30_000;
/** The cost of a skinned or morphed corner, in ordinary corners. */
const DEFORMING_COST = 4;
/** The greatest number of meshes that are read, evenly chosen. */
const MAX_MESHES = 2000;
/** At most this many instances of a mesh are read. */
const MAX_INSTANCES = 256;

/** A mesh, its places, and the triangles of it that are read. */
interface MeshReading {
  mesh: Mesh;
  places: readonly Matrix4[];
  /** The first corner, and the number of triangles. */
  start: number;
  triangles: number;
  /** The cost of reading all of its triangles. */
  cost: number;
}

/** Reads the triangles of meshes. */
interface Reader {
  toView: Matrix4;
  projection: Matrix4;
  outer: OuterPoints | undefined;
  /** Whether some meshes are left out, and the others stand for them. */
  isSample: boolean;
}

/**
 * Reads the triangles that a camera may see, with skins and morph targets in their present pose. The world matrices of the object and
 * the camera must be up to date.
 *
 * @param outer receives their corners, including those that are not seen
 */
export function readTriangles(object: Object3D, camera: Camera, outer?: OuterPoints): ProjectedTriangles {
  const shown = shownMeshes(object, camera);
  const readings = evenlyChosen(shown, MAX_MESHES).map(readingOf);
  const share = fairShare(
    readings.map(({ cost }) => cost),
    MAX_TRIANGLES,
  );
  // The numbers are rounded up, so each place has room for one more.
  const room = readings.reduce(
    (sum, { triangles, places, cost }) => sum + places.length * Math.ceil(triangles / stepOf(cost, share)),
    0,
  );
  const list = createProjectedTriangles(room);
  const toView = new Matrix4().copy(camera.matrixWorld).invert();
  const isSample = readings.length < shown.length;
  const sheet = { toView, projection: camera.projectionMatrix, outer, isSample };
  for (const reading of readings) readMesh(list, reading, stepOf(reading.cost, share), sheet);
  return list;
}

/** The step between triangles that are read. */
const stepOf = (cost: number, share: number): number => Math.max(1, Math.ceil(cost / share));

/** The visible meshes at or below an object. If some are opaque, `transparent` ones are left out, because one sees through them. */
function shownMeshes(object: Object3D, camera: Camera): Mesh[] {
  const shown: Mesh[] = [];
  object.traverseVisible((entry) => {
    if (!isSurfaceMesh(entry) || !entry.layers.test(camera.layers) || isBatched(entry)) return;
    if (entry.geometry?.attributes.position && materialsOf(entry).some(({ visible }) => visible)) shown.push(entry);
  });
  const opaque = shown.filter((mesh) => materialsOf(mesh).some(({ visible, transparent }) => visible && !transparent));
  return opaque.length > 0 ? opaque : shown;
}

function evenlyChosen<Entry>(entries: readonly Entry[], most: number): Entry[] {
  const step = Math.max(1, entries.length / most);
  return Array.from({ length: Math.floor(entries.length / step) }, (_, i) => entries[Math.floor(i * step)]);
}

function readingOf(mesh: Mesh): MeshReading {
  const { geometry } = mesh;
  const { drawRange, index, attributes } = geometry;
  const available = index ? index.count : attributes.position.count;
  const start = Math.max(0, drawRange.start);
  const triangles = Math.max(0, Math.floor((Math.min(available, drawRange.start + drawRange.count) - start) / 3));
  const places = placesOf(mesh);
  const isDeforming =
    'isSkinnedMesh' in mesh || (mesh.morphTargetInfluences ?? []).some((influence) => influence !== 0);
  return { mesh, places, start, triangles, cost: triangles * places.length * (isDeforming ? DEFORMING_COST : 1) };
}

/** The matrices to world space that a mesh is drawn with: those of some of its instances, if it has many. */
function placesOf(mesh: Mesh): Matrix4[] {
  if (!('isInstancedMesh' in mesh)) return [mesh.matrixWorld];
  const instanced = mesh as InstancedMesh;
  const step = Math.max(1, instanced.count / MAX_INSTANCES);
  return Array.from({ length: Math.floor(instanced.count / step) }, (_, i) => {
    const matrix = new Matrix4();
    instanced.getMatrixAt(Math.floor(i * step), matrix);
    return matrix.premultiply(mesh.matrixWorld);
  });
}

/** The greatest share of each need for which all together stay within a limit: small needs leave the rest to the others. */
function fairShare(needs: readonly number[], limit: number): number {
  let left = limit;
  for (const [i, need] of [...needs].sort((a, b) => a - b).entries()) {
    const share = left / (needs.length - i);
    if (need > share) return share;
    left -= need;
  }
  return Infinity;
}

const corners = [new Vector3(), new Vector3(), new Vector3()];
const projected = new Float64Array(9);
const edge = new Vector3();
const normal = new Vector3();
const inView = new Matrix4();
const onSheet = new Matrix4();

function readMesh(
  list: ProjectedTriangles,
  { mesh, places, start, triangles }: MeshReading,
  step: number,
  { toView, projection, outer, isSample }: Reader,
): void {
  const { index, attributes } = mesh.geometry;
  const openness = opennessOf(mesh);
  const vertexAt = (entry: number): number => (index ? index.getX(entry) : entry);
  for (const place of places) {
    inView.multiplyMatrices(toView, place);
    onSheet.multiplyMatrices(projection, inView);
    const hidden = hiddenSide(mesh, place);
    const front = place.determinant() < 0 ? -1 : 1;
    for (let triangle = 0; triangle < triangles; triangle += step) {
      const open = [0, 0];
      let inFront = 0;
      for (let corner = 0; corner < 3; corner++) {
        const vertex = vertexAt(start + 3 * triangle + corner);
        if (!(vertex < attributes.position.count)) break;
        mesh.getVertexPosition(vertex, corners[corner]);
        if (project(corners[corner], corner)) inFront++;
        for (const side of [0, 1]) open[side] += openness(vertex, side) / 3;
        const { x, y, z } = corners[corner].applyMatrix4(place);
        outer?.add(x, y, z);
      }
      if (inFront === 3) add(list, { hidden, front, open }, isSample || step > 1);
    }
  }
}

/** Projects a corner. @returns whether it is in front of the eye */
function project({ x, y, z }: Vector3, corner: number): boolean {
  const e = onSheet.elements;
  const v = inView.elements;
  const depth = e[3] * x + e[7] * y + e[11] * z + e[15];
  projected[3 * corner] = (e[0] * x + e[4] * y + e[8] * z + e[12]) / depth;
  projected[3 * corner + 1] = (e[1] * x + e[5] * y + e[9] * z + e[13]) / depth;
  // 1 / depth is linear on the sheet of a perspective camera; that of an orthographic one is always 1.
  const isFlat = e[3] === 0 && e[7] === 0 && e[11] === 0;
  projected[3 * corner + 2] = isFlat ? v[2] * x + v[6] * y + v[10] * z + v[14] : 1 / depth;
  return depth > 0;
}

/** The sides of a triangle. Those of the sheet are 1 for counter-clockwise, and −1 for clockwise. */
interface Sides {
  /** The side of the sheet that is not drawn; 0 for none. */
  hidden: number;
  /** The side of the sheet that its front has. */
  front: number;
  /** The share of directional light that reaches its front, and its back, through its baked occlusion. */
  open: readonly number[];
}

/** Adds the triangle of the present corners, unless only its hidden side is visible. */
function add(list: ProjectedTriangles, { hidden, front, open }: Sides, isSample: boolean): void {
  const [ax, ay, , bx, by, , cx, cy] = projected;
  const side = Math.sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
  if (!(side === 1 || side === -1) || side === hidden) return;
  normal.subVectors(corners[1], corners[0]).cross(edge.subVectors(corners[2], corners[0]));
  const length = normal.length();
  if (!(length > 0 && length < Infinity)) return;
  const { count } = list;
  normal.multiplyScalar(side / length).toArray(list.normals, 3 * count);
  list.corners.set(projected, 9 * count);
  list.openness[count] = open[side === front ? 0 : 1];
  list.isSample[count] = isSample ? 1 : 0;
  list.count++;
}

/** The side of triangles that is not drawn: 1 for counter-clockwise on the sheet, −1 for clockwise, 0 for none. */
function hiddenSide(mesh: Mesh, place: Matrix4): number {
  const [{ side }, ...others] = materialsOf(mesh);
  if (side === DoubleSide || others.some((material) => material.side !== side)) return 0;
  return (side === BackSide ? 1 : -1) * (place.determinant() < 0 ? -1 : 1);
}

/** Returns a function of a vertex: the share of directional light that reaches its front (0) or back (1) through its baked occlusion. */
function opennessOf(mesh: Mesh): (vertex: number, side: number) => number {
  const material = materialsOf(mesh).find(isHatching);
  const baked = mesh.geometry.attributes[hatchNormal.name];
  const strength = material?.occlusion ?? 0;
  if (strength === 0 || baked?.itemSize !== hatchNormal.itemSize) return () => 1;
  return (vertex, side) => openToLamps(occlusionOf(baked.getW(vertex), side === 1), strength);
}

/** Triangles as a camera sees them: plain data, in world space and on the sheet. */
export interface ProjectedTriangles {
  count: number;
  /**
   * Three numbers for each of three corners: x and y on the sheet, where −1 and 1 are its edges, and how near the corner is to the
   * eye. Nearness grows towards the eye, and is linear on the sheet.
   */
  corners: Float32Array;
  /** The unit normal of each triangle, on the visible side. */
  normals: Float32Array;
  /** The share of directional light that reaches each triangle through its baked occlusion: 1 without a bake. */
  openness: Float32Array;
  /** 1 for a triangle that stands for several omitted ones like it. */
  isSample: Uint8Array;
}

const NUMBERS_PER_TRIANGLE = 9;

/** Allocates room for a number of triangles. */
const createProjectedTriangles = (most: number): ProjectedTriangles => ({
  count: 0,
  corners: new Float32Array(NUMBERS_PER_TRIANGLE * most),
  normals: new Float32Array(3 * most),
  openness: new Float32Array(most),
  isSample: new Uint8Array(most),
});

/** Six axes and the diagonals between them: along each, both extremes are kept. */
const AXES = Float64Array.from(
  [-1, 0, 1]
    .flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z])))
    .slice(0, 13)
    .flat(),
);
const COUNT = AXES.length / 3;

/** The extreme points of an object along 26 directions, which stand for its whole extent. */
export class OuterPoints {
  private readonly reach = new Float64Array(2 * COUNT).fill(-Infinity);
  private readonly points = new Float64Array(6 * COUNT);

  /** Adds a point in world space. A point that is not finite is ignored. */
  add(x: number, y: number, z: number): void {
    const { reach } = this;
    for (let i = 0; i < COUNT; i++) {
      const along = AXES[3 * i] * x + AXES[3 * i + 1] * y + AXES[3 * i + 2] * z;
      if (along > reach[2 * i]) this.set(2 * i, along, x, y, z);
      if (-along > reach[2 * i + 1]) this.set(2 * i + 1, -along, x, y, z);
    }
  }

  /** Adds points given as x, y, z. */
  addAll(xyz: ArrayLike<number>): void {
    for (let i = 0; i + 2 < xyz.length; i += 3) this.add(xyz[i], xyz[i + 1], xyz[i + 2]);
  }

  /** x, y, z of each point; empty before any was added. */
  get xyz(): Float64Array {
    return this.reach[0] === -Infinity ? new Float64Array() : this.points;
  }

  private set(i: number, along: number, x: number, y: number, z: number): void {
    this.reach[i] = along;
    this.points[3 * i] = x;
    this.points[3 * i + 1] = y;
    this.points[3 * i + 2] = z;
  }
}
