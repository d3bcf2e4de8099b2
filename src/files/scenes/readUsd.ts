import { USDLoader } from 'three/addons/loaders/USDLoader.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { withStandIns } from './standIns.js';

/** Reads a USD file, as text, binary or in a package (USDZ). @throws Error as the loader has it */
export const readUsd = (bytes: Uint8Array, name: string): LoadedScene =>
  sceneOf(
    withStandIns(() => new USDLoader().parse(bytes.slice().buffer)),
    name,
  );
