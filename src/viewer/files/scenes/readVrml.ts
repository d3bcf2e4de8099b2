import type { BufferGeometry, Mesh, Object3D } from 'three';
import { VRMLLoader } from 'three/addons/loaders/VRMLLoader.js';
import { ModelError } from '../common/ModelError.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { mendFans } from './mendFans.js';
import { plainVrml } from './plainVrml.js';
import { withoutDocument } from './withoutDocument.js';

/** Reads a VRML 2 file. @throws ModelError if it contains unsupported nodes; Error of the loader */
export function readVrml(bytes: Uint8Array, name: string): LoadedScene {
  const text = new TextDecoder().decode(bytes);
  if (/^[^#"\n\r]*\b(?:EXTERN)?PROTO\b/m.test(text))
    throw new ModelError(`${name} defines nodes of its own (PROTO), which this page does not read.`);
  const plain = plainVrml(text);
  const root = withoutDocument(() => new VRMLLoader().parse(plain.text, ''));
  if (!root) return sceneOf(root, name);
  mendFans(root);
  if (!/\b(?:creaseAngle|Normal)\b/.test(text)) root.traverse(withoutNormals);
  return { ...sceneOf(root, name), notes: plain.notes };
}

/**
 * Removes the flat normals that the loader computes for face sets without normals and crease angle. They are computed later, with creases
 * kept.
 */
function withoutNormals(object: Object3D): void {
  const { geometry } = object as Partial<Mesh>;
  if ((geometry as (BufferGeometry & { _type?: string }) | undefined)?._type === 'mesh')
    geometry!.deleteAttribute('normal');
}
