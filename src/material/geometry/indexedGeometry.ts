import { BufferAttribute, type BufferGeometry } from 'three';
import { appendVertices } from '../../mesh/bake/appendVertices.js';
import type { BakeIndexedResult } from '../../mesh/bake/bakeIndexed.js';
import type { VertexWords } from '../../mesh/bake/expandPerCorner.js';
import { hatchNormal } from '../../mesh/bake/hatchNormal.js';
import { finishGeometry, type NotBaked, setNormals } from './preparedGeometry.js';
import { setForm } from './setForm.js';
import { setKeptAttribute } from './setKeptAttribute.js';
import type { KeptAttribute } from './vertexAttributes.js';

/** A kept attribute with a copy of its values from before the bake. */
export interface CopiedAttribute extends KeptAttribute, VertexWords {}

/** Fills the geometry with the index, all attributes (including those of added vertices), the bounds and the statistics. */
export function applyIndexed(
  geometry: BufferGeometry,
  attributes: readonly CopiedAttribute[],
  result: BakeIndexedResult & NotBaked,
): void {
  geometry.setIndex(new BufferAttribute(result.indices, 1));
  for (const attribute of attributes) {
    setKeptAttribute(geometry, attribute, appendVertices(attribute, result.addedVertices));
  }
  geometry.setAttribute(hatchNormal.name, new BufferAttribute(result.hatchNormals, hatchNormal.itemSize, true));
  setForm(geometry, result.form);
  if (result.normals) setNormals(geometry, result.normals);
  finishGeometry(geometry, 'indexed', result);
}
