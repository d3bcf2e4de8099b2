import type { JointFormsRequest } from './bakeJointForms.js';
import type { SurfaceRequest } from './bakeSurface.js';
import type { VertexWords } from './expandPerCorner.js';

/**
 * The buffers of a request, which are transferred with it. This function has a file of its own because the page needs it even
 * where only the worker loads the code of the bakes.
 */
export const bakeRequestBuffers = ({
  mesh,
  attributes = [],
}: SurfaceRequest & { attributes?: VertexWords[] }): ArrayBuffer[] => [
  mesh.positions.buffer,
  mesh.indices.buffer,
  ...attributes.map(({ words }) => words.buffer),
];

/** The buffers of a request for joint forms, which are transferred with it. */
export const jointRequestBuffers = ({ parts }: JointFormsRequest): ArrayBuffer[] =>
  parts.flatMap(({ mesh }) => [mesh.positions.buffer, mesh.indices.buffer]);
