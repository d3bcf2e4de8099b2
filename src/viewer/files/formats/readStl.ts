import { Mesh } from 'three';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { AsciiReader } from '../common/AsciiReader.js';
import { nearFloats } from '../mesh/fitModel.js';
import { checkReadTriangles, type NotedMesh, normalizeNormals, type PlainMesh } from '../mesh/PlainMesh.js';
import { triangulatePolygon } from '../mesh/triangulatePolygon.js';
import type { LoadedScene } from '../scenes/LoadedScene.js';

/** Reads an STL file. @param length of a binary one in bytes; undefined for ASCII */
export function readStl(bytes: Uint8Array, length: number | undefined): NotedMesh | LoadedScene {
  if (length === undefined) return { mesh: readAsciiStl(bytes), notes: [] };
  // Trailing bytes are cut off: with them, three's loader would take the file for text.
  return { root: new Mesh(new STLLoader().parse(bytes.slice(0, length).buffer)) };
}

/**
 * Reads an ASCII STL file in one pass; three's loader uses regular expressions that take minutes on some files. Loops of more than three
 * corners are triangulated; comments are skipped.
 */
function readAsciiStl(bytes: Uint8Array): PlainMesh {
  const reader = new AsciiReader(bytes);
  const positions: number[] = [];
  const normals: number[] = [];
  let normal = [0, 0, 0];
  let loop: number[] = [];
  const endLoop = (): void => {
    for (const corner of triangulatePolygon(loop)) {
      for (let axis = 0; axis < 3; axis++) positions.push(loop[3 * corner + axis]);
      normals.push(...normal);
    }
    loop = [];
  };
  while (!reader.isAtEnd) {
    if (reader.isAt('#')) {
      reader.skipLine();
      continue;
    }
    switch (reader.word().toLowerCase()) {
      case 'normal':
        normal = [reader.number(), reader.number(), reader.number()];
        break;
      case 'vertex':
        loop.push(reader.number(), reader.number(), reader.number());
        break;
      case 'facet':
      case 'endloop':
      case 'endfacet':
        endLoop();
        break;
      case 'solid':
      case 'endsolid':
        // The name of the solid follows, which may be any text.
        reader.skipLine();
        break;
    }
  }
  endLoop();
  checkReadTriangles(positions.length / 9);
  return {
    positions: nearFloats(positions),
    normals: normalizeNormals(Float32Array.from(normals)),
    colors: null,
    indices: null,
  };
}
