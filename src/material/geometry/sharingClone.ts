import { BufferGeometry } from 'three';

/** Creates a geometry that shares all data of a prepared one. Single attributes of the clone can be replaced. */
export function sharingClone(source: BufferGeometry): BufferGeometry {
  const clone = new BufferGeometry();
  clone.name = source.name;
  clone.userData = source.userData;
  clone.index = source.index;
  Object.assign(clone.attributes, source.attributes);
  Object.assign(clone.morphAttributes, source.morphAttributes);
  clone.morphTargetsRelative = source.morphTargetsRelative;
  clone.groups = source.groups;
  clone.drawRange = source.drawRange;
  clone.boundingBox = source.boundingBox;
  clone.boundingSphere = source.boundingSphere;
  return clone;
}

/** Frees only the attributes that the clone does not share; `dispose()` would free the shared buffers too. */
export function disposeSharingClone(clone: BufferGeometry, source: BufferGeometry): void {
  clone.index = null;
  for (const name of Object.keys(clone.attributes)) {
    if (clone.attributes[name] === source.attributes[name]) clone.deleteAttribute(name);
  }
  clone.dispose();
}
