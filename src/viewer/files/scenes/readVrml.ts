import type { BufferGeometry, Mesh, Object3D } from 'three';
import { VRMLLoader } from 'three/addons/loaders/VRMLLoader.js';
import { ModelError } from '../common/ModelError.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { mendFans } from './mendFans.js';
import { plainVrml } from './plainVrml.js';
import { withStandIns } from './standIns.js';

/** Reads a file of VRML 2. @throws ModelError if it holds what is not read; Error as the loader has it */
export function readVrml(bytes: Uint8Array, name: string): LoadedScene {
  const text = new TextDecoder().decode(bytes);
  if (/^[^#"\n\r]*\b(?:EXTERN)?PROTO\b/m.test(text))
    throw new ModelError(`${name} makes nodes of its own (PROTO), which this page does not read.`);
  const plain = plainVrml(text);
  const root = withStandIns(() => new VRMLLoader().parse(plain.text, ''));
  if (!root) return sceneOf(root, name);
  mendFans(root);
  if (!/\b(?:creaseAngle|Normal)\b/.test(text)) root.traverse(withoutNormals);
  return { ...sceneOf(root, name), notes: plain.notes };
}

/** A face set without normals and without an angle of its own is flat to the loader. It gets normals later, with edges kept. */
function withoutNormals(object: Object3D): void {
  const { geometry } = object as Partial<Mesh>;
  if ((geometry as (BufferGeometry & { _type?: string }) | undefined)?._type === 'mesh')
    geometry!.deleteAttribute('normal');
}
