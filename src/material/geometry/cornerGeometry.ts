import { BufferAttribute, type BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute } from 'three';
import type { BakeCornersResult } from '../../mesh/bake/bakeCorners.js';
import { CORNER_STRIDE, cornerLayout } from '../../mesh/bake/cornerLayout.js';
import { hatchNormal } from '../../mesh/bake/hatchNormal.js';
import { finishGeometry, type NotBaked, setNormals } from './preparedGeometry.js';
import { setForm } from './setForm.js';
import { setKeptAttribute } from './setKeptAttribute.js';
import type { KeptAttribute } from './vertexAttributes.js';

/** Fills the geometry with the baked corners, the kept attributes, the bounds and the statistics. */
export function applyCorners(
  geometry: BufferGeometry,
  kept: readonly KeptAttribute[],
  result: BakeCornersResult & NotBaked,
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
