import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import type { FindFile } from './FindFile.js';
import { mergeScene } from './mergeScene.js';
import type { PlainMesh } from './PlainMesh.js';

/** Reads an OBJ file, with the colours of its MTL file if that was dropped together with it. */
export async function readObj(bytes: Uint8Array, findFile: FindFile): Promise<PlainMesh> {
  const decoder = new TextDecoder();
  const text = decoder.decode(bytes);
  const loader = new OBJLoader();
  const library = /^\s*mtllib\s+(.+?)\s*$/m.exec(text)?.[1];
  const materials = library ? await findFile(library) : undefined;
  if (materials) {
    // Textures are not drawn, and a worker could not load them.
    const plain = decoder.decode(materials).replace(/^\s*(map_|bump|disp|decal|refl|norm)\S*.*$/gim, '');
    loader.setMaterials(new MTLLoader().parse(plain, ''));
  }
  return mergeScene(loader.parse(text));
}
