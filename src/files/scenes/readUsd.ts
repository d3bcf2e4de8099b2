import { USDLoader } from 'three/addons/loaders/USDLoader.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { mendFans } from './mendFans.js';
import { replace, withStandIns } from './standIns.js';

/** Reads a USD file, as text, binary or in a package (USDZ). @throws Error as the loader has it */
export async function readUsd(bytes: Uint8Array, name: string): Promise<LoadedScene> {
  const restore = await leaveNormalsOpen();
  try {
    const root = withStandIns(() => new USDLoader().parse(bytes.slice().buffer));
    if (root) mendFans(root);
    return sceneOf(root, name);
  } finally {
    restore();
  }
}

/**
 * Has the loader write zeros where a mesh has no normals, so that they are computed later, with edges kept. Its own are smooth across every
 * edge. A version of three.js that does this elsewhere keeps them.
 *
 * @returns a function that ends it
 */
async function leaveNormalsOpen(): Promise<() => void> {
  try {
    const { USDComposer } = await import('three/addons/loaders/usd/USDComposer.js');
    return replace(USDComposer.prototype, {
      _computeVertexNormals: (points: ArrayLike<number>) => new Float32Array(points.length),
    });
  } catch {
    return () => {};
  }
}
