import { Matrix3, type Mesh } from 'three';
import type { SurfaceDetails } from '../paint/PaintLook.js';
import { coordinatesOf, type Painted, type PaintNeeds, writeColor } from './PaintReader.js';
import type { MeshCopy } from './pose/meshCopies.js';
import type { PosedVertices } from './pose/posedVertices.js';
import type { SurfaceFrame } from './surfaceFrame.js';

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
