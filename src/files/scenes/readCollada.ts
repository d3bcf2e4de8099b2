import { ColladaLoader } from 'three/addons/loaders/ColladaLoader.js';
import { ColladaXml } from './ColladaXml.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { withStandIns } from './standIns.js';

/** Reads a COLLADA file (DAE), with its clips. @throws Error as the loader has it */
export const readCollada = (bytes: Uint8Array, name: string): LoadedScene =>
  sceneOf(
    withStandIns(() => new ColladaLoader().parse(new TextDecoder().decode(bytes), '')?.scene, ColladaXml),
    name,
  );
