import { asPhase } from '../slices/asPhase.js';
import type { Surface } from './bakeSurface.js';
import { expandPerCorner, type VertexWords, type Words } from './expandPerCorner.js';
import { packHatchNormals } from './packHatchNormals.js';
import { packNormals } from './packNormals.js';

/** The vertex attributes of the layouts that give each corner a vertex of its own. */
export interface CornerAttributes {
  /** Each corner's `hatchNormal`. */
  hatchNormals: Int16Array<ArrayBuffer>;
  /** x, y, z of each corner's smooth normal, if requested. */
  normals: Float32Array<ArrayBuffer> | null;
  /** The attributes of the request, in the same order, with one entry per corner. */
  attributes: Words[];
}

/** Writes the normals of each corner and copies `attributes` from the vertices that `indices` names. */
export function* packCornerAttributes(
  { hatchNormals, smoothNormals }: Surface,
  indices: Uint32Array,
  attributes: readonly VertexWords[],
): Generator<number, CornerAttributes, void> {
  const packedHatchNormals = yield* asPhase(packHatchNormals(hatchNormals, null), 0, 0.2);
  const normals = smoothNormals && (yield* asPhase(packNormals(smoothNormals, null), 0.2, 0.33));
  const expanded: Words[] = [];
  const share = 0.67 / Math.max(1, attributes.length);
  for (const [i, attribute] of attributes.entries()) {
    const from = 0.33 + i * share;
    expanded.push(yield* asPhase(expandPerCorner(attribute, indices), from, from + share));
  }
  return { hatchNormals: packedHatchNormals, normals, attributes: expanded };
}

/** The buffers of the attributes, which are transferred with them. */
export const cornerAttributeBuffers = ({ hatchNormals, normals, attributes }: CornerAttributes): ArrayBuffer[] => [
  hatchNormals.buffer,
  ...(normals ? [normals.buffer] : []),
  ...attributes.map((words) => words.buffer),
];
