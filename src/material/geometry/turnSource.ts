import { appendVertices, type VertexWords } from '../../mesh/bake/vertexWords.js';
import { normalsToTurn, turnTriangles } from '../../mesh/orientation/turnTriangles.js';
import type { TriangleMesh } from '../../mesh/TriangleMesh.js';
import type { attributeFromWords } from './bakedGeometry.js';
import type { KeptAttribute } from './vertexAttributes.js';

type AttributeOf = typeof attributeFromWords;

/** Copies of a geometry's data: its triangles, and the values of its attributes. */
interface Source {
  mesh: TriangleMesh;
  copied: VertexWords[];
}

/**
 * Turns triangles of a source. Vertices that turned and other triangles share are copied with all attributes; normals that point to what is
 * the back now are reversed, also in morph targets, and tangents keep the direction of the texture coordinates.
 *
 * @param kept the attributes in `copied`
 * @param isTurned for each triangle 1 if it is turned
 * @param attributeOf makes an attribute of words; given, since what this file shares with those that load earlier would be one more file
 * @returns the source, and the vertices that were copied
 */
export function turnSource<Given extends Source>(
  source: Given,
  kept: readonly KeptAttribute[],
  isTurned: Uint8Array,
  attributeOf: AttributeOf,
): Given & { copies: Uint32Array<ArrayBuffer> } {
  const indices = source.mesh.indices.slice();
  const copies = turnTriangles(indices, isTurned, source.mesh.positions.length / 3);
  const words = { words: new Uint32Array(source.mesh.positions.buffer), wordsPerVertex: 3 };
  const mesh = { positions: new Float32Array(appendVertices(words, copies).buffer), indices };
  const copied = source.copied.map((one) => ({ ...one, words: appendVertices(one, copies) }));
  const at = kept.findIndex(({ name, isMorphTarget }) => name === 'normal' && !isMorphTarget);
  if (at !== -1) {
    const normals = attributeOf(kept[at].attribute, copied[at].words);
    const vertices = normalsToTurn(mesh, isTurned, (vertex, normal) => {
      normal[0] = normals.getX(vertex);
      normal[1] = normals.getY(vertex);
      normal[2] = normals.getZ(vertex);
    });
    reverse(vertices, kept, copied, attributeOf);
  }
  return { ...source, mesh, copied, copies };
}

function reverse(
  vertices: readonly number[],
  kept: readonly KeptAttribute[],
  copied: readonly VertexWords[],
  attributeOf: AttributeOf,
): void {
  for (const [i, { name, attribute }] of kept.entries()) {
    if (name !== 'normal' && name !== 'tangent') continue;
    // Half floats are read and written by these methods alone.
    const values = attributeOf(attribute, copied[i].words);
    for (const vertex of vertices) {
      if (name === 'normal') values.setXYZ(vertex, -values.getX(vertex), -values.getY(vertex), -values.getZ(vertex));
      else if (attribute.itemSize > 3) values.setW(vertex, -values.getW(vertex));
    }
  }
}
