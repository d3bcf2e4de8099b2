import type { VertexWords, Words } from './expandPerCorner.js';

/** Returns the words of an attribute, followed by copies of the entries of `vertices`. */
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
