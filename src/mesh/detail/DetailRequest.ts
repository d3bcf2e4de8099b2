import type { HatchedVertices } from './hatchedMesh.js';

/** A baked mesh of which levels are to be made. */
export interface DetailRequest extends HatchedVertices {
  indices: Uint32Array<ArrayBuffer>;
  /** Radius of the bounding sphere, in object units. */
  radius: number;
  /** The address of meshoptimizer's simplifier. */
  simplifier: string;
}

/** The buffers of a request, which are transferred with it. */
export const detailRequestBuffers = ({
  positions,
  hatchNormals,
  uvs,
  colors,
  forms,
  indices,
}: DetailRequest): ArrayBuffer[] =>
  [positions, hatchNormals, uvs, colors, forms, indices].flatMap((array) => (array ? [array.buffer] : []));
