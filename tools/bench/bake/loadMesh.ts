import type { TriangleMesh } from '../internals.js';
import { loadModel } from '../loadModel.js';

/** The input of a bake: a model, or a mesh that is hard to bake: `fan100k`, `torus500kShuffled`. */
export async function loadMesh(name: string): Promise<TriangleMesh> {
  if (name === 'fan100k') return fan(100_000);
  const { attributes, index } = await loadModel(name.replace('Shuffled', ''));
  const mesh = { positions: new Float32Array(attributes.position!.array), indices: new Uint32Array(index!.array) };
  return name.endsWith('Shuffled') ? shuffled(mesh) : mesh;
}

/** `count` triangles around one vertex. */
function fan(count: number): TriangleMesh {
  const positions = new Float32Array(3 * (count + 1));
  const indices = new Uint32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const angle = (2 * Math.PI * i) / count;
    positions.set([Math.cos(angle), Math.sin(angle), 0], 3 * (i + 1));
    indices.set([0, i + 1, ((i + 1) % count) + 1], 3 * i);
  }
  return { positions, indices };
}

/** The same mesh with its vertices and triangles in a random order, always the same one. */
function shuffled({ positions, indices }: TriangleMesh): TriangleMesh {
  const random = lcg(1);
  const order = permutation(positions.length / 3, random);
  const triangles = permutation(indices.length / 3, random);
  const result = { positions: positions.slice(), indices: indices.slice() };
  for (const [vertex, to] of order.entries())
    result.positions.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * to);
  for (const [triangle, to] of triangles.entries()) {
    for (let k = 0; k < 3; k++) result.indices[3 * to + k] = order[indices[3 * triangle + k]];
  }
  return result;
}

/** Numbers in [0, 1) from a linear congruential generator (constants of Numerical Recipes). */
function lcg(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function permutation(length: number, random: () => number): Uint32Array {
  const order = Uint32Array.from({ length }, (_, i) => i);
  for (let i = length - 1; i > 0; i--) {
    const j = Math.floor(random() * (i + 1));
    [order[i], order[j]] = [order[j], order[i]];
  }
  return order;
}
