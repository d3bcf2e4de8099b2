import { asPhase, forEachChunk } from '../phases.js';
import { weldPositions } from '../weldPositions.js';
import { NO_SAMPLE, type OcclusionMesh } from './OcclusionScene.js';
import { toWorldNormals, toWorldPoints } from './worldSpace.js';

/** A mesh in world space that has every position only once. */
export interface OcclusionSurface {
  positions: Float32Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
  samples: SurfaceSamples | null;
}

/** The samples of a mesh: every pair of position and normal among its vertices, without repetition. */
export interface SurfaceSamples {
  positions: Float32Array<ArrayBuffer>;
  normals: Float32Array<ArrayBuffer>;
  /** A tangent vector that points away from the border: of length 1 at a straight border, near 0 in the interior. */
  inward: Float32Array<ArrayBuffer>;
  /** For each vertex its sample, or NO_SAMPLE. */
  sampleOf: Uint32Array<ArrayBuffer>;
}

/** Welds vertices at the same position, since geometries prepared for hatching may have three vertices per triangle. */
export function* sampleSurface(mesh: OcclusionMesh): Generator<number, OcclusionSurface, void> {
  const { indices, normals, toWorld, isInsideOut } = mesh;
  const { canonical } = yield* asPhase(weldPositions(mesh.positions), 0, 0.3);
  const places = numbered(canonical, indices);
  const surface = {
    positions: toWorldPoints(pick(mesh.positions, places.firsts), toWorld),
    indices: indices.map((vertex) => places.numbers[vertex]),
  };
  yield 0.4;
  if (normals === null) return { ...surface, samples: null };

  const turned = yield* asPhase(weldPositions(normals), 0.4, 0.6);
  const pairs = new Uint32Array(normals.length);
  for (let vertex = 0; vertex < canonical.length; vertex++) {
    pairs[3 * vertex] = canonical[vertex];
    pairs[3 * vertex + 1] = turned.canonical[vertex];
  }
  // Vertices with equal pairs are welded too: only bits are compared, so integers may stand in for floats.
  const both = yield* asPhase(weldPositions(new Float32Array(pairs.buffer)), 0.6, 0.8);
  const { firsts, numbers } = numbered(both.canonical, indices);
  const samples = {
    positions: toWorldPoints(pick(mesh.positions, firsts), toWorld),
    normals: toWorldNormals(pick(normals, firsts), toWorld, isInsideOut ? -1 : 1),
    inward: new Float32Array(3 * firsts.length),
    sampleOf: numbers,
  };
  yield* asPhase(
    forEachChunk(indices.length / 3, (start, end) => addInward(samples, indices, start, end)),
    0.8,
    1,
  );
  limitInward(samples);
  return { ...surface, samples };
}

/**
 * Numbers the canonical vertices that triangles use, from 0 on.
 *
 * @returns for each vertex its number or NO_SAMPLE, and for each number its canonical vertex
 */
function numbered(canonical: Uint32Array, indices: Uint32Array) {
  const numbers = new Uint32Array(canonical.length).fill(NO_SAMPLE);
  const firsts = new Uint32Array(canonical.length);
  let count = 0;
  for (const vertex of indices) {
    const first = canonical[vertex];
    if (numbers[first] === NO_SAMPLE) {
      firsts[count] = first;
      numbers[first] = count++;
    }
    numbers[vertex] = numbers[first];
  }
  return { numbers, firsts: firsts.subarray(0, count) };
}

function pick(triples: Float32Array, vertices: Uint32Array): Float32Array {
  const picked = new Float32Array(3 * vertices.length);
  for (let i = 0; i < vertices.length; i++) {
    picked[3 * i] = triples[3 * vertices[i]];
    picked[3 * i + 1] = triples[3 * vertices[i] + 1];
    picked[3 * i + 2] = triples[3 * vertices[i] + 2];
  }
  return picked;
}

/** Adds up the unit vectors from each sample to the middles of its triangles. */
function addInward({ positions, inward, sampleOf }: SurfaceSamples, indices: Uint32Array, start: number, end: number) {
  for (let corner = 3 * start; corner < 3 * end; corner += 3) {
    const a = 3 * sampleOf[indices[corner]];
    const b = 3 * sampleOf[indices[corner + 1]];
    const c = 3 * sampleOf[indices[corner + 2]];
    const x = (positions[a] + positions[b] + positions[c]) / 3;
    const y = (positions[a + 1] + positions[b + 1] + positions[c + 1]) / 3;
    const z = (positions[a + 2] + positions[b + 2] + positions[c + 2]) / 3;
    for (let k = 0; k < 3; k++) {
      const sample = k === 0 ? a : k === 1 ? b : c;
      const u = x - positions[sample];
      const v = y - positions[sample + 1];
      const w = z - positions[sample + 2];
      const length = Math.sqrt(u * u + v * v + w * w);
      if (!(length > 0)) continue;
      inward[sample] += u / length;
      inward[sample + 1] += v / length;
      inward[sample + 2] += w / length;
    }
  }
}

/** Projects each vector into the tangent plane, and shortens it to length 1 if it is longer. */
function limitInward({ normals, inward }: SurfaceSamples): void {
  for (let i = 0; i < inward.length; i += 3) {
    const rise = inward[i] * normals[i] + inward[i + 1] * normals[i + 1] + inward[i + 2] * normals[i + 2];
    for (let axis = 0; axis < 3; axis++) inward[i + axis] -= rise * normals[i + axis];
    const length = Math.hypot(inward[i], inward[i + 1], inward[i + 2]);
    if (length <= 1) continue;
    for (let axis = 0; axis < 3; axis++) inward[i + axis] /= length;
  }
}
