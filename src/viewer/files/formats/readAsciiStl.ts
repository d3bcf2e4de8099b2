import { AsciiReader } from '../common/AsciiReader.js';
import { checkReadTriangles } from '../mesh/checkTriangleCount.js';
import { nearFloats } from '../mesh/nearFloats.js';
import type { PlainMesh } from '../mesh/PlainMesh.js';
import { triangulatePolygon } from '../mesh/triangulatePolygon.js';

/**
 * Reads an ASCII STL file in one pass; three's loader uses regular expressions that take minutes on some files. Loops of more than three
 * corners are triangulated; comments are skipped.
 */
export function readAsciiStl(bytes: Uint8Array): PlainMesh {
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
  return { positions: nearFloats(positions), normals: unitLengths(normals), colors: null, indices: null };
}

/** Normalizes normals. Zero and NaN ones become zero, and are computed from the surface later. */
function unitLengths(normals: readonly number[]): Float32Array {
  const scaled = Float32Array.from(normals);
  for (let i = 0; i < scaled.length; i += 3) {
    const length = Math.hypot(scaled[i], scaled[i + 1], scaled[i + 2]);
    for (let k = i; k < i + 3; k++) scaled[k] = length > 0 && length < Infinity ? scaled[k] / length : 0;
  }
  return scaled;
}
