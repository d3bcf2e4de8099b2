import type { Mesh, Object3D } from 'three';
import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';
import { unzip } from '../archives/zip.js';
import { join3mf } from './join3mf.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { withoutDocument } from './withoutDocument.js';

/** Reads a 3MF file. @throws ModelError if it is damaged; Error of the loader */
export async function read3mf(bytes: Uint8Array, name: string): Promise<LoadedScene> {
  const joined = join3mf(await unzip(bytes, name, () => true), name);
  const scene = sceneOf(
    withoutDocument(() => new ThreeMFLoader().parse(joined.bytes.slice().buffer)),
    name,
  );
  showAlpha(scene.root);
  return { ...scene, notes: joined.notes };
}

/** Makes materials with an alpha colour transparent: the loader sets only their opacity. */
function showAlpha(root: Object3D): void {
  root.traverse((object) => {
    for (const material of [(object as Partial<Mesh>).material ?? []].flat())
      if (material.opacity < 1) material.transparent = true;
  });
}
