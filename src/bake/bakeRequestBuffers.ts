import type { SurfaceRequest } from './bakeSurface.js';
import type { VertexWords } from './expandPerCorner.js';

/**
 * The buffers of a request, to be transferred with it. Apart from the bakes themselves: the page needs this even where only
 * the worker has their code.
 */
export const bakeRequestBuffers = ({
  mesh,
  attributes = [],
}: SurfaceRequest & { attributes?: VertexWords[] }): ArrayBuffer[] => [
  mesh.positions.buffer,
  mesh.indices.buffer,
  ...attributes.map(({ words }) => words.buffer),
];
