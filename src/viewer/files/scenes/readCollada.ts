import { ColladaLoader } from 'three/addons/loaders/ColladaLoader.js';
import { ColladaXml, takeMasks } from './ColladaXml.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { withoutDocument } from './withoutDocument.js';

/** Reads a COLLADA file (DAE), with its clips. @throws Error of the loader */
export function readCollada(bytes: Uint8Array, name: string): LoadedScene {
  const text = new TextDecoder().decode(bytes);
  const root = withoutDocument(() => new ColladaLoader().parse(text, '')?.scene, ColladaXml);
  if (root) takeMasks(root);
  return sceneOf(root, name);
}
