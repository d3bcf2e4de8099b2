import { BufferGeometry, InstancedBufferGeometry } from 'three';
import type { CornerRange } from './cornerRange.js';
import { isInstanced } from './vertexAttributes.js';

/**
 * Creates the new geometry with everything that the bake does not change: name, user data, groups and instanced attributes. It
 * is created before the bake starts, so that later changes of `source` have no effect.
 */
export function startGeometry(source: BufferGeometry, range: CornerRange): BufferGeometry {
  const geometry = 'isInstancedBufferGeometry' in source ? new InstancedBufferGeometry() : new BufferGeometry();
  if (geometry instanceof InstancedBufferGeometry) {
    geometry.instanceCount = (source as InstancedBufferGeometry).instanceCount;
  }
  geometry.name = source.name;
  geometry.userData = { ...source.userData };
  geometry.morphTargetsRelative = source.morphTargetsRelative;
  for (const group of range.groups) geometry.addGroup(group.start, group.count, group.materialIndex);
  const clonedBuffers = {};
  for (const [name, attribute] of Object.entries(source.attributes)) {
    if (!isInstanced(attribute)) continue;
    geometry.setAttribute(name, 'data' in attribute ? attribute.clone(clonedBuffers) : attribute.clone());
  }
  return geometry;
}
