import { asPhase } from '../phases.js';
import { chooseViews } from './chooseViews.js';
import { MAP_SIZE, NO_SAMPLE, type OcclusionMesh, type OcclusionScene } from './OcclusionScene.js';
import { type OcclusionSurface, sampleSurface } from './sampleSurface.js';

/**
 * Lift of samples off their surface along the normal, in pixels. A map holds the depth at the middle of a pixel, which is at most 0.71
 * pixels from the sample. There a plane of any slope is at most that far above the sample, along the normal.
 */
const LIFT = 1;
/** Distance in pixels by which samples at a border are moved inwards, out of walls that meet the surface there. */
const INWARD = 1.5;

/** Transforms all meshes to world space and chooses the samples and views. At least one mesh must have normals. */
export function* startOcclusion({ meshes }: { meshes: OcclusionMesh[] }): Generator<number, OcclusionScene, void> {
  const surfaces: OcclusionSurface[] = [];
  for (const [i, mesh] of meshes.entries()) {
    surfaces.push(yield* asPhase(sampleSurface(mesh), i / (meshes.length + 1), (i + 1) / (meshes.length + 1)));
  }
  const occluders = surfaces.filter((_, i) => meshes[i].occludes);
  const sampled = surfaces.flatMap(({ samples }) => samples ?? []);
  const scene = {
    positions: joined(
      Float32Array,
      occluders.map(({ positions }) => positions),
    ),
    indices: joinedIndices(occluders.map(({ indices, positions }) => [indices, positions.length / 3])),
    samplePositions: joined(
      Float32Array,
      sampled.map(({ positions }) => positions),
    ),
    sampleNormals: joined(
      Float32Array,
      sampled.map(({ normals }) => normals),
    ),
    sampleOf: sampled.map(({ sampleOf }) => sampleOf),
  };
  let first = 0;
  for (const { sampleOf, positions } of sampled) {
    for (let i = 0; i < sampleOf.length; i++) if (sampleOf[i] !== NO_SAMPLE) sampleOf[i] += first;
    first += positions.length / 3;
  }
  const sums = new Float32Array(2 * first);
  const views = chooseViews(scene.samplePositions);
  const inward = joined(
    Float32Array,
    sampled.map((samples) => samples.inward),
  );
  for (const { radius, samples } of views) {
    const pixel = (2 * radius) / MAP_SIZE;
    for (const sample of samples) {
      for (let i = 3 * sample; i < 3 * sample + 3; i++) {
        scene.samplePositions[i] += pixel * (LIFT * scene.sampleNormals[i] + INWARD * inward[i]);
      }
    }
  }
  return { ...scene, sums, views };
}

/** Concatenates arrays. */
function joined<A extends Float32Array | Uint32Array>(Type: new (length: number) => A, arrays: readonly A[]): A {
  const whole = new Type(arrays.reduce((sum, { length }) => sum + length, 0));
  let offset = 0;
  for (const array of arrays) {
    whole.set(array, offset);
    offset += array.length;
  }
  return whole;
}

/** Concatenates the indices of several meshes, and shifts them to the concatenated vertices. */
function joinedIndices(parts: readonly [indices: Uint32Array, vertices: number][]): Uint32Array<ArrayBuffer> {
  let first = 0;
  const shifted = parts.map(([indices, vertices]) => {
    const moved = indices.map((vertex) => vertex + first);
    first += vertices;
    return moved;
  });
  return joined<Uint32Array<ArrayBuffer>>(Uint32Array, shifted);
}
