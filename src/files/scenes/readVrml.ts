import { VRMLLoader } from 'three/addons/loaders/VRMLLoader.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { withStandIns } from './standIns.js';

/** Reads a file of VRML 2. @throws Error as the loader has it */
export const readVrml = (bytes: Uint8Array, name: string): LoadedScene =>
  sceneOf(
    withStandIns(() => new VRMLLoader().parse(new TextDecoder().decode(bytes), '')),
    name,
  );
