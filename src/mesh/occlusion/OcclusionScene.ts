/** A mesh that takes part in a bake of ambient occlusion. It may occlude others and, if it has normals, receive occlusion. */
export interface OcclusionMesh {
  /** x, y, z of each vertex, in object space. */
  positions: Float32Array<ArrayBuffer>;
  /** Three entries per triangle. */
  indices: Uint32Array<ArrayBuffer>;
  /** The normal of each vertex, of any length, in object space. With null the mesh only occludes others. */
  normals: Float32Array<ArrayBuffer> | null;
  /** The matrix from object space to world space, by columns. */
  toWorld: number[];
  /** Which sides of it are drawn by any of its materials. The occlusion of those is measured. */
  sides: 'front' | 'back' | 'both';
  /** For each triangle the sides that occlude others, as a sum of FRONT and BACK. */
  occluding: Uint8Array<ArrayBuffer>;
}

/** The sides of a triangle that occlude. */
export const FRONT = 1;
export const BACK = 2;

/** A sphere covered by depth maps, and the samples that are tested in these maps. */
export interface OcclusionView {
  center: [x: number, y: number, z: number];
  radius: number;
  samples: Uint32Array<ArrayBuffer>;
}

/** The state of a bake, in world space. Plain data: the tasks pass it from thread to thread. */
export interface OcclusionScene {
  /** x, y, z of the vertices of all meshes that occlude. */
  positions: Float32Array<ArrayBuffer>;
  /**
   * Three entries per triangle that occludes: first the triangles with two sides, then the others, whose corners run counter-clockwise
   * as seen from the side that occludes.
   */
  indices: Uint32Array<ArrayBuffer>;
  /** The number of triangles of which both sides occlude. */
  twoSided: number;
  /**
   * x, y, z of each sample: a position on a surface where occlusion is measured, lifted off it by a pixel of its view. First come those of
   * vertices, then those within triangles, each of which is of a stand-in for a vertex.
   */
  samplePositions: Float32Array<ArrayBuffer>;
  /** The unit normal of each sample of a vertex, zero if it has none; then those of stand-ins. */
  sampleNormals: Float32Array<ArrayBuffer>;
  /** For each sample within a triangle the number of its stand-in, after those of vertices. */
  standsFor: Uint32Array<ArrayBuffer>;
  /** For each stand-in the sample of the vertex beside which it counts, or in place of which if that is buried in a body. */
  standIns: Uint32Array<ArrayBuffer>;
  /**
   * Two sums for each sample of a vertex, then for each stand-in: the cosines of all directions so far, and the cosines of those in which
   * the sky is visible.
   */
  sums: Float32Array<ArrayBuffer>;
  views: OcclusionView[];
  /** For each mesh with normals the sample of each vertex, or NO_SAMPLE; where both sides are drawn, that of the front. */
  sampleOf: Uint32Array<ArrayBuffer>[];
  /** For each mesh with normals how far after a sample that of its back is; 0 where one side is drawn. */
  backAfter: number[];
}

/** The sample of a vertex that no triangle uses. */
export const NO_SAMPLE = 0xffffffff;

/** The width and height of a depth map, in pixels. */
export const MAP_SIZE = 512;
