import type { Mesh, Object3D } from 'three';
import { check3ds } from './check3ds.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { smoothByGroups } from './smoothByGroups.js';
import { TdsFaces } from './TdsFaces.js';
import { withoutDocument } from './withoutDocument.js';

/** Reads a 3DS file. @throws ModelError if it is damaged; Error of the loader */
export function read3ds(bytes: Uint8Array, name: string): LoadedScene {
  const plain = bytes.slice();
  check3ds(plain, name);
  const loader = new TdsFaces();
  const root = withoutDocument(() => loader.parse(plain.buffer, ''));
  root?.traverse((object) => setNormals(object, loader));
  return sceneOf(root, name);
}

/**
 * Gives a mesh the normals of its smoothing groups, or none: the loader's are smooth across every edge, and missing ones are computed later
 * with creases kept.
 */
function setNormals(object: Object3D, { smoothing }: TdsFaces): void {
  const mesh = object as Mesh;
  const groups = smoothing.get(mesh.geometry);
  if (groups) mesh.geometry = smoothByGroups(mesh.geometry, groups);
  else (object as Partial<Mesh>).geometry?.deleteAttribute('normal');
}
