import type { Mesh, Object3D } from 'three';
import { TDSLoader } from 'three/addons/loaders/TDSLoader.js';
import { check3ds } from './check3ds.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { withStandIns } from './standIns.js';

/** Reads a 3DS file. @throws ModelError if it is damaged; Error as the loader has it */
export function read3ds(bytes: Uint8Array, name: string): LoadedScene {
  check3ds(bytes, name);
  const root = withStandIns(() => new TDSLoader().parse(bytes.slice().buffer, ''));
  root?.traverse(withoutNormals);
  return sceneOf(root, name);
}

/** The loader's normals are smooth across every edge. Without them, they are computed later, with edges kept. */
function withoutNormals(object: Object3D): void {
  (object as Partial<Mesh>).geometry?.deleteAttribute('normal');
}
