import { forEachChunk } from '../timeSlicing/forEachChunk.js';

/** Vertex data as unsigned integers, so that one function can copy values of every type bit by bit. */
export type Words = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

/** An attribute whose values are copied from vertices to corners unchanged. */
export interface VertexWords {
  words: Words;
  wordsPerVertex: number;
}

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
