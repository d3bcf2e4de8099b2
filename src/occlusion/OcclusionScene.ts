/** A mesh that takes part in a bake of occlusion: what it hides and, if it has normals, what is hidden of it. */
export interface OcclusionMesh {
  /** x, y, z of each vertex, object space. */
  positions: Float32Array<ArrayBuffer>;
  /** Three entries per triangle. */
  indices: Uint32Array<ArrayBuffer>;
  /** The normal of each vertex, of any length, object space; null: the mesh only hides others. */
  normals: Float32Array<ArrayBuffer> | null;
  /** The matrix from object space to world space, by columns. */
  toWorld: number[];
  /** Whether its back is what is seen. */
  isInsideOut: boolean;
  /** Whether it hides anything. */
  hides: boolean;
}

/** A part of the scene that depth maps are drawn of, and the samples that are looked up in them. */
export interface OcclusionView {
  center: [x: number, y: number, z: number];
  radius: number;
  samples: Uint32Array<ArrayBuffer>;
}

/** The state of a bake: plain data, which tasks hand on from thread to thread. World space. */
export interface OcclusionScene {
  /** x, y, z of the vertices of all meshes that hide something. */
  positions: Float32Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
  /** Places on surfaces that are asked how much of the sky they see; lifted off them by a pixel of their view. */
  samplePositions: Float32Array<ArrayBuffer>;
  /** Unit normals; zero where nothing is known. */
  sampleNormals: Float32Array<ArrayBuffer>;
  /** For each sample the cosines of all directions above the surface so far, and of those that hit nothing, added up. */
  sums: Float32Array<ArrayBuffer>;
  views: OcclusionView[];
  /** For each mesh with normals the sample of each vertex, or NO_SAMPLE. */
  sampleOf: Uint32Array<ArrayBuffer>[];
  /** How many pairs of opposite directions have been looked along. */
  pairs: number;
}

/** Stands for the sample of a vertex that no triangle uses. */
export const NO_SAMPLE = 0xffffffff;

/** Pixels along one side of a depth map. */
export const MAP_SIZE = 512;
