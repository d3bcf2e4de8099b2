import { BufferAttribute, type BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute } from 'three';
import type { BakeCornersResult } from '../bake/bakeCorners.js';
import { CORNER_STRIDE, cornerLayout } from '../bake/cornerLayout.js';
import { hatchNormal } from '../bake/hatchNormal.js';
import { setForm } from './formGeometry.js';
import { finishGeometry, setNormals } from './preparedGeometry.js';
import type { Repairs } from './repairValues.js';
import { type KeptAttribute, setKeptAttribute } from './vertexAttributes.js';

/** Fills the geometry with the baked corners, the kept attributes, the bounds and the statistics. */
export function applyCorners(
  geometry: BufferGeometry,
  kept: readonly KeptAttribute[],
  result: BakeCornersResult & Repairs,
): void {
  geometry.setAttribute('position', new BufferAttribute(result.positions, 3));
  const buffer = new InterleavedBuffer(result.corners, CORNER_STRIDE);
  let offset = 0;
  for (const { name, itemSize } of cornerLayout) {
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, itemSize, offset));
    offset += itemSize;
  }
  geometry.setAttribute(hatchNormal.name, new BufferAttribute(result.hatchNormals, hatchNormal.itemSize, true));
  for (const [i, attribute] of kept.entries()) setKeptAttribute(geometry, attribute, result.attributes[i]);
  setForm(geometry, result.form);
  if (result.normals) setNormals(geometry, result.normals);
  finishGeometry(geometry, 'corner', result);
}
