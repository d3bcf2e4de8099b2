import { USDLoader } from 'three/addons/loaders/USDLoader.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { mendFans } from './mendFans.js';
import { withStandIns } from './standIns.js';

/** Reads a USD file, as text, binary or in a package (USDZ). @throws Error as the loader has it */
export function readUsd(bytes: Uint8Array, name: string): LoadedScene {
  const root = withStandIns(() => new USDLoader().parse(bytes.slice().buffer));
  if (root) mendFans(root);
  return sceneOf(root, name);
}
