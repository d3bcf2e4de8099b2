import { Mesh } from 'three';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import type { PlainMesh } from '../mesh/PlainMesh.js';
import type { LoadedScene } from '../scenes/LoadedScene.js';
import { readAsciiStl } from './readAsciiStl.js';

const HEADER_BYTES = 84;
const TRIANGLE_BYTES = 50;

/** Reads an STL file, ASCII or binary. */
export function readStl(bytes: Uint8Array): PlainMesh | LoadedScene {
  const length = binaryStlLength(bytes);
  if (length === undefined) return readAsciiStl(bytes);
  // Without what follows the triangles: three's loader would take the file for text.
  return { root: new Mesh(new STLLoader().parse(bytes.slice(0, length).buffer)) };
}

/** The bytes that a binary STL file takes by its count of triangles, or undefined if it cannot be one. */
export function binaryStlLength(bytes: Uint8Array): number | undefined {
  if (bytes.length < HEADER_BYTES) return undefined;
  const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  const length = HEADER_BYTES + count * TRIANGLE_BYTES;
  return count > 0 && length <= bytes.length ? length : undefined;
}
