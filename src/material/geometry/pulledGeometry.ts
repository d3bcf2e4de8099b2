import { BufferAttribute, type BufferGeometry } from 'three';
import type { BakePullResult } from '../../mesh/bake/bakePull.js';
import { hatchNormal } from '../../mesh/bake/hatchNormal.js';
import { PulledVertices } from './PulledVertices.js';
import { finishGeometry, type NotBaked, setNormals } from './preparedGeometry.js';
import { setPulledVertices } from './pulledVerticesOf.js';
import { setForm } from './setForm.js';
import { setKeptAttribute } from './setKeptAttribute.js';
import type { KeptAttribute } from './vertexAttributes.js';

/** Fills the geometry with the baked corners, the textures, the kept attributes, the bounds and the statistics. */
export function applyPull(
  geometry: BufferGeometry,
  kept: readonly KeptAttribute[],
  result: BakePullResult & NotBaked,
): void {
  geometry.setAttribute('position', new BufferAttribute(result.positions, 3));
  geometry.setAttribute(hatchNormal.name, new BufferAttribute(result.hatchNormals, hatchNormal.itemSize, true));
  for (const [i, attribute] of kept.entries()) setKeptAttribute(geometry, attribute, result.attributes[i]);
  setForm(geometry, result.form);
  if (result.normals) setNormals(geometry, result.normals);
  const { triangleVertices, vertexPositions } = result;
  finishGeometry(geometry, 'pull', result, triangleVertices.byteLength + vertexPositions.byteLength);
  setPulledVertices(geometry, new PulledVertices(result));
}
