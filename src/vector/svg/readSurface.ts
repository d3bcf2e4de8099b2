import { type BufferAttribute, type BufferGeometry, Matrix3, type Matrix4, type Mesh, Vector3 } from 'three';
import { combined, cross, normalize, type Vec3, vectorAt } from '../../look/vectors.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { STIPPLE_MAP_SIZE } from '../../material/tam/patternSizes.js';
import { stippleMap } from '../../material/tam/stippleMap.js';
import { formLayout, hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import { occlusionOf } from '../../mesh/occlusion/occlusionSides.js';
import { asPhase } from '../../mesh/phases.js';
import { SEEN_BACK, SEEN_FRONT } from '../Bvh.js';
import type { StippledSurface } from '../DrawnScene.js';
import {
  FIELD,
  FIELD_NORMAL,
  FORM,
  type LineSurface,
  OCCLUSION,
  STRIDE,
  TONE_NORMAL,
  VIEW,
  WORLD,
} from '../LineSurface.js';
import type { SurfaceDetails } from '../paint/PaintLook.js';
import { formVarying } from '../shading/lineFunctions.js';
import type { MeshCopy } from './meshCopies.js';
import { coordinatesOf, type Painted, type PaintNeeds, writeColor } from './PaintReader.js';
import type { PosedVertices } from './posedVertices.js';
import { objectFrame, rowsOf, type SurfaceFrame } from './surfaceFrame.js';
import { weldBoth, weldPoints } from './weldPoints.js';

/** Vertices per step. */
const CHUNK = 4096;

/** Reads the part of a mesh that a material draws. seen: bits of the visible sides. Yields its progress. */
export function* readSurface(
  source: DetailSource,
  { corners, firstTriangle }: TriangleRange,
  frame: SurfaceFrame,
  seen: number,
): Generator<number, LineSurface, void> {
  const { mesh, posed } = source;
  const { geometry } = mesh;
  const vertexCount = geometry.attributes.position.count;
  const places = yield* asPhase(placesOfPose(geometry, posed), 0, 0.3);
  // A mesh of many parts has many more vertices than any part of it.
  const inPart = numbered(corners, vertexCount);
  const used = new Int32Array(inPart.count);
  for (const vertex of corners) used[inPart.numbers[vertex]] = vertex;
  const vertices = new Float64Array(STRIDE * used.length);
  const writer = new VertexWriter(geometry, posed, frame, vertices);
  for (let v = 0; v < used.length; v++) {
    if (v % CHUNK === 0) yield 0.3 + (0.7 * v) / used.length;
    writer.write(used[v], places[used[v]], STRIDE * v);
  }
  const placesOfUsed = used.map((vertex) => places[vertex]);
  const ofPlaces = numbered(placesOfUsed, vertexCount).numbers;
  const triangles = new Int32Array(corners).map((vertex) => inPart.numbers[vertex]);
  const details = readDetails(source, { corners, firstTriangle }, frame);
  const parents = new Int32Array(corners.length / 3);
  for (let t = 0; t < parents.length; t++) parents[t] = firstTriangle + t;
  yield 1;
  const viewToObject = new Matrix3().setFromMatrix4(frame.toView).invert();
  return {
    vertices,
    placeOf: placesOfUsed.map((place) => ofPlaces[place]),
    triangles,
    parents,
    drawsFront: (seen & SEEN_FRONT) !== 0,
    drawsBack: (seen & SEEN_BACK) !== 0,
    viewToField: rowsOf(new Matrix3().multiplyMatrices(frame.toField, viewToObject)),
    details: details && {
      ...{ ...details, corners: triangles.slice() },
      numbers: yield* perCorner(details.numbers, details.stride, used),
    },
  };
}

/** Numbers the indices of a list in their order, which they keep; how many there are is the count. */
function numbered(indices: ArrayLike<number>, end: number): { numbers: Int32Array; count: number } {
  const numbers = new Int32Array(end);
  for (let i = 0; i < indices.length; i++) numbers[indices[i]] = 1;
  let count = 0;
  for (let i = 0; i < end; i++) if (numbers[i] === 1) numbers[i] = count++;
  return { numbers, count };
}

/** A pose may separate vertices that are at one place at rest, or join others: vertices share a place if they do in both. */
function* placesOfPose(
  geometry: BufferGeometry,
  { positions, toRest }: PosedVertices,
): Generator<number, Uint32Array, void> {
  const { position } = geometry.attributes;
  const atRest = yield* weldPoints(position.count, (vertex, axis) => position.getComponent(vertex, axis));
  if (!toRest) return atRest;
  const asPosed = yield* weldPoints(position.count, (vertex, axis) => positions[3 * vertex + axis]);
  return weldBoth(atRest, asPosed);
}

const transposed = /* @__PURE__ */ new Matrix3();

/** The transform of normals from rest to the pose: the transpose of the map back. */
const transposedAt = (toRest: Float64Array, vertex: number): Matrix3 =>
  transposed.fromArray(toRest, 9 * vertex).transpose();

/** Writes the numbers of vertices. */
class VertexWriter {
  private readonly vector = new Vector3();

  constructor(
    private readonly geometry: BufferGeometry,
    private readonly posed: PosedVertices,
    private readonly frame: SurfaceFrame,
    private readonly vertices: Float64Array,
  ) {}

  /**
   * @param place the vertex whose position all vertices at this place get
   * @param o offset at which its numbers are written
   */
  write(vertex: number, place: number, o: number): void {
    const { frame, posed, vector, vertices } = this;
    const { position, normal } = this.geometry.attributes;
    const put = (offset: number) => vector.toArray(vertices, o + offset);
    const at = () => vector.fromArray(posed.positions, 3 * place);
    at().applyMatrix4(frame.toWorld);
    put(WORLD);
    at().applyMatrix4(frame.toView);
    put(VIEW);
    vector
      .fromBufferAttribute(position as BufferAttribute, place)
      .sub(frame.fieldOrigin)
      .applyMatrix3(frame.toField);
    const atRest = vector.toArray() as Vec3;
    if (frame.isCutAsPosed) at().sub(frame.fieldOrigin).applyMatrix3(frame.toField);
    put(FIELD);
    vector
      .fromArray(posed.normals!, 3 * vertex)
      .applyMatrix3(frame.normalToWorld)
      .normalize();
    put(TONE_NORMAL);
    const strokes = this.geometry.attributes[hatchNormal.name];
    if (strokes) {
      const baked = frame.hasOcclusion ? strokes.getW(vertex) : 0;
      for (const side of [0, 1]) vertices[o + OCCLUSION + side] = occlusionOf(baked, side === 1);
      vector.fromBufferAttribute(strokes as BufferAttribute, vertex);
    }
    // The smoothed normal, or the geometry's own where it was not prepared.
    if (!strokes || vector.lengthSq() <= 0.25) vector.fromBufferAttribute(normal as BufferAttribute, vertex);
    if (frame.isCutAsPosed && posed.toRest) vector.applyMatrix3(transposedAt(posed.toRest, vertex));
    vector.applyMatrix3(frame.normalToField).normalize();
    put(FIELD_NORMAL);
    this.writeForm(vertex, atRest, o + FORM);
  }

  /** Lines that follow the form are fixed to the surface at rest. */
  private writeForm(vertex: number, field: Vec3, offset: number): void {
    const { attributes } = this.geometry;
    const value = attributes[formLayout.value.name];
    if (!value) return;
    for (const [i, layout] of [formLayout.slope, formLayout.crossing].entries()) {
      const slope = attributes[layout.name];
      const scale = 2 ** Math.round(32767 * slope.getW(vertex));
      this.vector.fromBufferAttribute(slope as BufferAttribute, vertex).applyMatrix3(this.frame.normalToField);
      const gradient = this.vector.multiplyScalar(scale).toArray() as Vec3;
      const { rest } = formVarying(gradient, value.getComponent(vertex, i), field);
      const o = offset + 4 * i;
      for (let k = 0; k < 3; k++) this.vertices[o + k] = gradient[k];
      this.vertices[o + 3] = rest;
    }
  }
}

/** Reads the part of a mesh that a material draws in dots. seen: bits of the visible sides. Yields its progress. */
export function* readStippled(
  source: DetailSource,
  material: HatchingMaterial,
  range: TriangleRange,
  worldToView: Matrix4,
  seen: number,
): Generator<number, Pick<StippledSurface, 'surface' | 'size' | 'set' | 'layers'>, void> {
  const { tilesPerObjectUnit, strokeWidth, screenSpaceShare, strokeLayers, latticeSpacing, crossFrom } = material;
  const frame = objectFrame(source.mesh, source.copy.toWorld, worldToView);
  const surface = yield* readSurface(source, range, frame, seen);
  return {
    surface,
    // If no stroke width is known, dots are one pixel wide, as the material draws them.
    size: { dotPixels: strokeWidth ?? 1, tilesPerObjectUnit, screenSpaceShare },
    layers: { shift: latticeSpacing / tilesPerObjectUnit, crossFrom: strokeLayers === 'tone' ? crossFrom : null },
    set: { cells: STIPPLE_MAP_SIZE, texels: (stippleMap().image.data as Uint8Array).slice() },
  };
}

/** Corners per step, of whole triangles. */
const FLAT_CHUNK = 3 * 1024;

/** The numbers of the vertex of each corner, so many per vertex. Yields meanwhile. */
function* perCorner(numbers: ArrayLike<number>, stride: number, vertices: Int32Array): Generator<number, Float64Array> {
  const spread = new Float64Array(stride * vertices.length);
  for (let corner = 0; corner < vertices.length; corner++) {
    if (corner % FLAT_CHUNK === 0) yield 1;
    for (let i = 0; i < stride; i++) spread[stride * corner + i] = numbers[stride * vertices[corner] + i];
  }
  return spread;
}

/** A surface with flat shading: each triangle gets vertices of its own with its normal. Yields meanwhile. */
export function* flattened(surface: LineSurface): Generator<number, LineSurface, void> {
  const { triangles, placeOf, details } = surface;
  const vertices = yield* perCorner(surface.vertices, STRIDE, triangles);
  for (let corner = 0; corner < triangles.length; corner += 3) {
    if (corner % FLAT_CHUNK === 0) yield 1;
    const offsets = [0, 1, 2].map((k) => STRIDE * (corner + k));
    const [a, b, c] = offsets.map((o) => vectorAt(vertices, o + WORLD));
    const normal = normalize(cross(combined(1, b, -1, a), combined(1, c, -1, a)));
    for (const o of offsets) vertices.set(normal, o + TONE_NORMAL);
  }
  const corners = triangles.map((_, corner) => corner);
  const numbers = details && (yield* perCorner(details.numbers, details.stride, triangles));
  return {
    ...{ ...surface, vertices, triangles: corners, placeOf: triangles.map((vertex) => placeOf[vertex]) },
    details: details && numbers && { ...details, corners, numbers },
  };
}

/** A range of triangles of a mesh with one material. */
export interface TriangleRange {
  /** Vertices of corners. */
  corners: Uint32Array;
  /** Index of the first of them among the triangles of the scene. */
  firstTriangle: number;
}

/** The source of the details of a part of a mesh. */
export interface DetailSource {
  mesh: Mesh;
  copy: MeshCopy;
  posed: PosedVertices;
  material: Painted;
  /** Null if the part has one colour everywhere. */
  paint: PaintNeeds | null;
}

/** Offset of the coordinates of the first channel in the details of a surface. */
export const firstCoordinate = ({ posed }: DetailSource, frame: SurfaceFrame | null): number =>
  hasMaps(posed, frame) ? 9 : 0;

/** Whether lines are fixed to a surface at rest that is drawn in a pose. */
const hasMaps = ({ toRest }: PosedVertices, frame: SurfaceFrame | null): frame is SurfaceFrame =>
  toRest !== null && frame !== null && !frame.isCutAsPosed;

/**
 * Reads the details of a part of a mesh; null for none.
 *
 * @param frame of its lines; null where it has none
 */
export function readDetails(
  source: DetailSource,
  { corners, firstTriangle }: TriangleRange,
  frame: SurfaceFrame | null,
): SurfaceDetails | null {
  const { posed, paint } = source;
  const first = firstCoordinate(source, frame);
  const stride = first + 2 * (paint?.channels.length ?? 0) + (paint?.hasColors ? 4 : 0);
  if (stride === 0) return null;
  const numbers = new Float64Array((stride * posed.positions.length) / 3);
  if (first > 0) writeMaps(posed.toRest!, frame!, numbers, stride);
  if (paint) writePaint(source, paint, numbers, stride, first);
  return { firstTriangle, corners, stride, numbers, viewToField: first > 0 ? 0 : null };
}

function writeMaps(toRest: Float64Array, frame: SurfaceFrame, numbers: Float64Array, stride: number): void {
  const viewToObject = new Matrix3().setFromMatrix4(frame.toView).invert();
  const map = new Matrix3();
  for (let v = 0; 9 * v < toRest.length; v++) {
    map
      .fromArray(toRest, 9 * v)
      .premultiply(frame.toField)
      .multiply(viewToObject);
    map.transpose().toArray(numbers as unknown as number[], stride * v);
  }
}

function writePaint(
  { mesh, copy, material }: DetailSource,
  { channels, hasColors }: PaintNeeds,
  numbers: Float64Array,
  stride: number,
  first: number,
): void {
  const coordinates = channels.map((channel) => mesh.geometry.attributes[coordinatesOf(channel)]);
  for (let v = 0; stride * v < numbers.length; v++) {
    const o = stride * v + first;
    for (const [i, uv] of coordinates.entries()) {
      numbers[o + 2 * i] = uv.getX(v);
      numbers[o + 2 * i + 1] = uv.getY(v);
    }
    if (hasColors) writeColor(mesh, material, copy, v, numbers, o + 2 * channels.length);
  }
}
