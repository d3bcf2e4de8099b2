/** A triangle mesh as typed arrays, which a worker can transfer without a copy. */
export interface PlainMesh {
  /** Three components per vertex. */
  positions: Float32Array;
  /** Three components per vertex, or null if the source has none. Zero vectors are computed later. */
  normals: Float32Array | null;
  /** Linear RGB, three components per vertex, or null if the source has none. */
  colors: Float32Array | null;
  /** Three per triangle, or null if every three vertices in order make one. */
  indices: Uint32Array | null;
  /** Two components per vertex; only in meshes with pictures. */
  uvs?: Float32Array;
  /** Contiguous ranges of corners by picture and opacity; only in meshes with pictures or see-through parts. */
  ranges?: PictureRange[];
}

/** Consecutive corners with the same picture and opacity. */
export interface PictureRange {
  start: number;
  count: number;
  /** The index of the picture, or -1 for none. */
  picture: number;
  /** Whether the range is see-through, as glass is. */
  isSeeThrough?: boolean;
}

/** A mesh, with notes for the caption on what was left out. */
export interface NotedMesh {
  mesh: PlainMesh;
  notes: string[];
}

/** The number of triangles in a mesh. */
export function triangleCount(mesh: PlainMesh): number {
  return Math.floor((mesh.indices?.length ?? mesh.positions.length / 3) / 3);
}

/** The buffers to transfer with a mesh. */
export function meshBuffers(mesh: PlainMesh): ArrayBuffer[] {
  const arrays = [mesh.positions, mesh.normals, mesh.colors, mesh.indices, mesh.uvs];
  return arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : []));
}
