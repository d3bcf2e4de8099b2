import { asPhase, forEachChunk } from '../phases.js';
import type { Surface } from './bakeSurface.js';
import { formBuffers, type PackedForm, packForm } from './packForm.js';
import { packHatchNormals, packNormals } from './packNormals.js';
import type { VertexWords, Words } from './vertexWords.js';

/** The vertex attributes of layouts with three vertices per triangle. */
export interface CornerAttributes {
  /** Each corner's `hatchNormal`. */
  hatchNormals: Int16Array<ArrayBuffer>;
  /** x, y, z of each corner's smooth normal, if requested. */
  normals: Float32Array<ArrayBuffer> | null;
  /** Each corner's attributes of lines that follow the form, if requested. */
  form: PackedForm | null;
  /** The attributes of the request, in the same order, with one entry per corner. */
  attributes: Words[];
}

/** Writes the normals of each corner and copies `attributes` from the vertices that `indices` names. */
export function* packCornerAttributes(
  { hatchNormals, smoothNormals, form }: Surface,
  indices: Uint32Array,
  attributes: readonly VertexWords[],
): Generator<number, CornerAttributes, void> {
  const packedHatchNormals = yield* asPhase(packHatchNormals(hatchNormals, null), 0, 0.2);
  const normals = smoothNormals && (yield* asPhase(packNormals(smoothNormals, null), 0.2, 0.3));
  const packedForm = form && (yield* asPhase(packForm(form, form.radius, null), 0.3, 0.4));
  const expanded: Words[] = [];
  const share = 0.6 / Math.max(1, attributes.length);
  for (const [i, attribute] of attributes.entries()) {
    const from = 0.4 + i * share;
    expanded.push(yield* asPhase(expandPerCorner(attribute, indices), from, from + share));
  }
  return { hatchNormals: packedHatchNormals, normals, form: packedForm, attributes: expanded };
}

/** The buffers that are transferred with the attributes. */
export const cornerAttributeBuffers = ({
  hatchNormals,
  normals,
  form,
  attributes,
}: CornerAttributes): ArrayBuffer[] => [
  hatchNormals.buffer,
  ...(normals ? [normals.buffer] : []),
  ...formBuffers(form),
  ...attributes.map((words) => words.buffer),
];

/** Copies the words of each corner's vertex to the corner. */
export function* expandPerCorner(source: VertexWords, indices: Uint32Array): Generator<number, Words, void> {
  const { words, wordsPerVertex } = source;
  const expanded = new (words.constructor as new (length: number) => Words)(indices.length * wordsPerVertex);
  yield* forEachChunk(indices.length, (start, end) => expandRange(source, indices, expanded, start, end));
  return expanded;
}

function expandRange(
  { words, wordsPerVertex }: VertexWords,
  indices: Uint32Array,
  expanded: Words,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const from = indices[corner] * wordsPerVertex;
    const to = corner * wordsPerVertex;
    for (let i = 0; i < wordsPerVertex; i++) expanded[to + i] = words[from + i];
  }
}
