import { BufferGeometry } from 'three';

/** A geometry that shares all buffers, textures and statistics of a prepared one. Its attributes can be exchanged one by one. */
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

/** Frees what a clone has for itself. three.js would free every buffer it sees. */
export function disposeSharingClone(clone: BufferGeometry, source: BufferGeometry): void {
  clone.index = null;
  for (const name of Object.keys(clone.attributes)) {
    if (clone.attributes[name] === source.attributes[name]) clone.deleteAttribute(name);
  }
  clone.dispose();
}
