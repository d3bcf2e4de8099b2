import { Mesh } from 'three';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import type { NotedMesh } from '../mesh/PlainMesh.js';
import type { LoadedScene } from '../scenes/LoadedScene.js';
import { binaryStlLength } from './binaryStlLength.js';
import { readAsciiStl } from './readAsciiStl.js';

/** Reads an STL file, ASCII or binary. */
export function readStl(bytes: Uint8Array): NotedMesh | LoadedScene {
  const length = binaryStlLength(bytes);
  if (length === undefined) return { mesh: readAsciiStl(bytes), notes: [] };
  // Trailing bytes are cut off: with them, three's loader would take the file for text.
  return { root: new Mesh(new STLLoader().parse(bytes.slice(0, length).buffer)) };
}
