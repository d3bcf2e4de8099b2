/** Vertex data as unsigned integers, so that one function can copy values of every type bit by bit. */
export type Words = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

/** An attribute whose values are copied from vertices to corners unchanged. */
export interface VertexWords {
  words: Words;
  wordsPerVertex: number;
}

/** The words of an attribute, followed by copies of the entries of `vertices`. */
export function appendVertices({ words, wordsPerVertex }: VertexWords, vertices: Uint32Array): Words {
  if (vertices.length === 0) return words;
  const appended = new (words.constructor as new (length: number) => Words)(
    words.length + vertices.length * wordsPerVertex,
  );
  appended.set(words);
  for (const [i, vertex] of vertices.entries()) {
    const from = vertex * wordsPerVertex;
    for (let j = 0; j < wordsPerVertex; j++) appended[words.length + i * wordsPerVertex + j] = words[from + j];
  }
  return appended;
}
