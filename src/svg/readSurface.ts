import { type BufferAttribute, type BufferGeometry, Matrix3, Matrix4, type Mesh, Vector3 } from 'three';
import { formLayout } from '../bake/formLayout.js';
import { hatchNormal } from '../bake/hatchNormal.js';
import { formVarying } from '../engraving/readForm.js';
import type { Mat3 } from '../engraving/screenGradient.js';
import type { Vec3 } from '../engraving/vectors.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { writeFieldFrame } from '../material/parts/fieldFrame.js';
import { asPhase } from '../slices/asPhase.js';
import { SEEN_BACK, SEEN_FRONT } from '../vector/Bvh.js';
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
} from '../vector/LineSurface.js';
import { placesOf } from './placesOf.js';

/** Matrices between a mesh, the world, a view and the space that lines are cut in. */
export interface SurfaceFrame {
  toWorld: Matrix4;
  toView: Matrix4;
  normalToWorld: Matrix3;
  fieldOrigin: Vector3;
  toField: Matrix3;
  normalToField: Matrix3;
}

/** @param worldToView of the camera */
export function surfaceFrame(mesh: Mesh, { tilesPerUnit }: HatchingMaterial, worldToView: Matrix4): SurfaceFrame {
  const fieldOrigin = { value: new Vector3() };
  const objectToField = { value: new Matrix3() };
  const objectToFieldNormal = { value: new Matrix3() };
  writeFieldFrame({ fieldOrigin, objectToField, objectToFieldNormal }, tilesPerUnit, mesh.geometry, mesh);
  return {
    toWorld: mesh.matrixWorld,
    toView: new Matrix4().multiplyMatrices(worldToView, mesh.matrixWorld),
    normalToWorld: new Matrix3().getNormalMatrix(mesh.matrixWorld),
    fieldOrigin: fieldOrigin.value,
    toField: objectToField.value,
    normalToField: objectToFieldNormal.value,
  };
}

/** The same where the space is that of the object, as of dots. */
export function objectFrame(mesh: Mesh, worldToView: Matrix4): SurfaceFrame {
  return {
    toWorld: mesh.matrixWorld,
    toView: new Matrix4().multiplyMatrices(worldToView, mesh.matrixWorld),
    normalToWorld: new Matrix3().getNormalMatrix(mesh.matrixWorld),
    fieldOrigin: new Vector3(),
    toField: new Matrix3(),
    normalToField: new Matrix3(),
  };
}

/** How much the normals of a surface lean along each axis of its field, all together. */
export function leaningOf({ vertices }: LineSurface): Vec3 {
  const sums = [0, 1, 2].map((axis) => {
    let sum = 0;
    for (let o = FIELD_NORMAL + axis; o < vertices.length; o += STRIDE) sum += Math.abs(vertices[o]);
    return sum;
  });
  return [sums[0], sums[1], sums[2]];
}

/** The triangles of a mesh that one material draws. */
export interface TriangleRange {
  /** The vertices of corners. */
  corners: Uint32Array;
  /** The triangle of the scene that the first of them is. */
  firstTriangle: number;
}

/** Vertices are read so many at a time. */
const CHUNK = 4096;

/** Reads the part of a mesh that a material draws. seen: bits of the sides that are. Yields its progress. */
export function* readSurface(
  geometry: BufferGeometry,
  { corners, firstTriangle }: TriangleRange,
  frame: SurfaceFrame,
  seen: number,
): Generator<number, LineSurface, void> {
  const { position } = geometry.attributes;
  const places = yield* asPhase(
    placesOf(position.count, (vertex, axis) => position.getComponent(vertex, axis)),
    0,
    0.3,
  );
  const vertexCount = position.count;
  const vertices = new Float64Array(STRIDE * vertexCount);
  const writer = new VertexWriter(geometry, frame, vertices);
  for (let v = 0; v < vertexCount; v++) {
    if (v % CHUNK === 0) yield 0.3 + (0.7 * v) / vertexCount;
    writer.write(v, places[v]);
  }
  const isMirrored = frame.toWorld.determinant() < 0;
  const triangles = Int32Array.from(corners);
  if (isMirrored) {
    for (let c = 0; c < triangles.length; c += 3) [triangles[c], triangles[c + 1]] = [triangles[c + 1], triangles[c]];
  }
  const viewToField = new Matrix3().setFromMatrix4(frame.toView).invert().premultiply(frame.toField);
  return {
    vertices,
    placeOf: Int32Array.from(places),
    triangles,
    parents: Int32Array.from({ length: corners.length / 3 }, (_, t) => firstTriangle + t),
    drawsFront: (seen & SEEN_FRONT) !== 0,
    drawsBack: (seen & SEEN_BACK) !== 0,
    viewToField: rowsOf(viewToField),
  };
}

export function rowsOf({ elements: e }: Matrix3): Mat3 {
  return [
    [e[0], e[3], e[6]],
    [e[1], e[4], e[7]],
    [e[2], e[5], e[8]],
  ];
}

/** Writes the numbers of vertices. */
class VertexWriter {
  private readonly vector = new Vector3();

  constructor(
    private readonly geometry: BufferGeometry,
    private readonly frame: SurfaceFrame,
    private readonly vertices: Float64Array,
  ) {}

  /** @param place the vertex whose position stands for all at the same place */
  write(vertex: number, place: number): void {
    const { frame, vector, vertices } = this;
    const { position, normal } = this.geometry.attributes;
    const o = STRIDE * vertex;
    const put = (offset: number) => vector.toArray(vertices, o + offset);
    const at = () => vector.fromBufferAttribute(position as BufferAttribute, place);
    at().applyMatrix4(frame.toWorld);
    put(WORLD);
    at().applyMatrix4(frame.toView);
    put(VIEW);
    at().sub(frame.fieldOrigin).applyMatrix3(frame.toField);
    put(FIELD);
    const field = vector.toArray() as Vec3;
    vector
      .fromBufferAttribute(normal as BufferAttribute, vertex)
      .applyMatrix3(frame.normalToWorld)
      .normalize();
    put(TONE_NORMAL);
    const strokes = this.geometry.attributes[hatchNormal.name];
    if (strokes) {
      vertices[o + OCCLUSION] = Math.max(-strokes.getW(vertex), 0);
      vector.fromBufferAttribute(strokes as BufferAttribute, vertex);
    }
    // Geometry that was never prepared still has its own normals.
    if (!strokes || vector.lengthSq() <= 0.25) vector.fromBufferAttribute(normal as BufferAttribute, vertex);
    vector.applyMatrix3(frame.normalToField).normalize();
    put(FIELD_NORMAL);
    this.writeForm(vertex, field);
  }

  private writeForm(vertex: number, field: Vec3): void {
    const { attributes } = this.geometry;
    const value = attributes[formLayout.value.name];
    if (!value) return;
    for (const [i, layout] of [formLayout.slope, formLayout.crossing].entries()) {
      const slope = attributes[layout.name];
      const scale = 2 ** Math.round(32767 * slope.getW(vertex));
      this.vector.fromBufferAttribute(slope as BufferAttribute, vertex).applyMatrix3(this.frame.normalToField);
      const gradient = this.vector.multiplyScalar(scale).toArray() as Vec3;
      const { rest } = formVarying(gradient, value.getComponent(vertex, i), field);
      const o = STRIDE * vertex + FORM + 4 * i;
      for (let k = 0; k < 3; k++) this.vertices[o + k] = gradient[k];
      this.vertices[o + 3] = rest;
    }
  }
}
