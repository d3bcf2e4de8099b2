import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { meshOf } from '../meshes.js';

/** Vertices and faces of an OBJ file. */
export function readObj(text: string): TriangleMesh {
  const vertices: number[][] = [];
  const triangles: number[][] = [];
  for (const line of text.split('\n')) {
    const [kind, ...words] = line.trim().split(/\s+/);
    if (kind === 'v') vertices.push(words.slice(0, 3).map(Number));
    if (kind !== 'f') continue;
    const face = words.map((word) => Number.parseInt(word, 10) - 1);
    for (let k = 2; k < face.length; k++) triangles.push([face[0], face[k - 1], face[k]]);
  }
  return meshOf(vertices, triangles);
}
