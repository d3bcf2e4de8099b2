/** A triangle mesh as typed arrays, so that a worker can transfer it without a copy. */
export interface PlainMesh {
  /** Three numbers per vertex. */
  positions: Float32Array;
  /** Three numbers per vertex, or null if the source has none. Those that are missing or zero are computed. */
  normals: Float32Array | null;
  /** Linear RGB, three numbers per vertex, or null if the source has none. */
  colors: Float32Array | null;
  /** Three per triangle, or null if every three vertices in a row make one. */
  indices: Uint32Array | null;
  /** Two numbers per vertex, only of meshes with pictures. */
  uvs?: Float32Array;
  /** Ranges of corners by picture and opacity, without gaps between them; only of meshes with pictures or see-through parts. */
  ranges?: PictureRange[];
}

/** Consecutive corners that are drawn with one picture and one opacity. */
export interface PictureRange {
  start: number;
  count: number;
  /** The index of the picture, or -1 for none. */
  picture: number;
  /** Whether what lies behind is seen through them, as through glass. */
  isSeeThrough?: boolean;
}

/** A mesh, and what the caption is to say of what is not in it. */
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
