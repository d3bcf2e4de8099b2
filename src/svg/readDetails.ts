import { Matrix3 } from 'three';
import type { SurfaceDetails } from '../vector/SurfaceDetails.js';
import type { PosedVertices } from './posedVertices.js';
import type { SurfaceFrame } from './surfaceFrame.js';
import type { TriangleRange } from './TriangleRange.js';

/** Reads what a surface has beside what all have; null if that is nothing. */
export function readDetails(
  { toRest, positions }: PosedVertices,
  { corners, firstTriangle }: TriangleRange,
  frame: SurfaceFrame,
): SurfaceDetails | null {
  if (!toRest || frame.isCutAsPosed) return null;
  const count = positions.length / 3;
  const numbers = new Float64Array(9 * count);
  const viewToObject = new Matrix3().setFromMatrix4(frame.toView).invert();
  const map = new Matrix3();
  for (let v = 0; v < count; v++) {
    map
      .fromArray(toRest, 9 * v)
      .premultiply(frame.toField)
      .multiply(viewToObject);
    map.transpose().toArray(numbers as unknown as number[], 9 * v);
  }
  return { firstTriangle, corners, stride: 9, numbers, viewToField: 0 };
}
