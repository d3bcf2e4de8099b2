import { forEachChunk } from '../slices/forEachChunk.js';

/** Vertex data as plain words, so that one function copies every type bit by bit. */
export type Words = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

/** An attribute whose values are copied from vertices to corners unchanged. */
export interface VertexWords {
  words: Words;
  wordsPerVertex: number;
}

/** Gives each corner a copy of its vertex's words. */
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
