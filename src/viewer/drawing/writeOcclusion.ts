import type { BufferGeometry } from 'three';
import type { PlainMesh } from '../files/mesh/PlainMesh.js';

/** The normalised 16-bit integer that stands for 1, and the byte that does. */
const [ONE, BYTE_ONE] = [0x7fff, 0xff];

/**
 * Writes ambient occlusion that was baked before to a geometry that was prepared from a mesh, as `bakeOcclusion` does. The corners of both are
 * the same.
 *
 * @param occlusion a byte for each vertex of the mesh, from 0 (sees the whole sky) to 255 (sees nothing of it); then four bytes for each corner
 *   that differs from its vertex, because a sharp edge goes through that: its number in three, the lowest first, and its occlusion
 */
export function writeOcclusion({ index, attributes }: BufferGeometry, mesh: PlainMesh, occlusion: Uint8Array): void {
  const { array } = attributes.hatchNormal;
  const corners = (index ?? attributes.hatchNormal).count;
  const write = (corner: number, byte: number): void => {
    array[4 * (index ? index.array[corner] : corner) + 3] = -Math.round((ONE / BYTE_ONE) * byte);
  };
  for (let corner = 0; corner < corners; corner++)
    write(corner, occlusion[mesh.indices ? mesh.indices[corner] : corner]);
  for (let i = mesh.positions.length / 3; i + 3 < occlusion.length; i += 4) {
    const corner = occlusion[i] + (occlusion[i + 1] << 8) + (occlusion[i + 2] << 16);
    if (corner < corners) write(corner, occlusion[i + 3]);
  }
}
