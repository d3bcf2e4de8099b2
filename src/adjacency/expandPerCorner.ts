import { inChunks } from './inChunks.js';

/** Vertex data seen as plain words, so that one function copies every type bit by bit. */
export type Words = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

/** An attribute whose values are copied from vertices to corners unchanged. */
export interface VertexWords {
  words: Words;
  wordsPerVertex: number;
}

/** Gives each corner a copy of its vertex's words. */
export function* expandPerCorner(
  { words, wordsPerVertex }: VertexWords,
  indices: Uint32Array,
): Generator<number, Words, void> {
  const expanded = new (words.constructor as new (length: number) => Words)(indices.length * wordsPerVertex);
  yield* inChunks(indices.length, (start, end) => {
    for (let corner = start; corner < end; corner++) {
      const source = indices[corner]! * wordsPerVertex;
      const target = corner * wordsPerVertex;
      for (let i = 0; i < wordsPerVertex; i++) expanded[target + i] = words[source + i]!;
    }
  });
  return expanded;
}
