/** A triangle mesh as bare arrays, so that it can be posted from the reading worker without a copy. */
export interface PlainMesh {
  /** Three numbers per vertex. */
  positions: Float32Array;
  /** Three numbers per vertex, or null where the source has none: they are computed then. */
  normals: Float32Array | null;
  /** Linear RGB, three numbers per vertex, or null for a model without colours. */
  colors: Float32Array | null;
  /** Three per triangle; null when every three vertices in a row make one. */
  indices: Uint32Array | null;
}

/** How many triangles a mesh holds. */
export function triangleCount(mesh: PlainMesh): number {
  return Math.floor((mesh.indices?.length ?? mesh.positions.length / 3) / 3);
}

/** The buffers to hand over when a mesh is posted. */
export function meshBuffers(mesh: PlainMesh): ArrayBuffer[] {
  const arrays = [mesh.positions, mesh.normals, mesh.colors, mesh.indices];
  return arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : []));
}
