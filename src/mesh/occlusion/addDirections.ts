import { asPhase, forEachChunk } from '../phases.js';
import { createDepthMaps, type DepthMaps, drawDepths, mapAxes, type Projection, projectionOf } from './depthMaps.js';
import { MAP_SIZE, NO_SAMPLE, type OcclusionScene, type OcclusionView } from './OcclusionScene.js';

/** The result of `addDirections`. */
export interface OcclusionResult {
  scene: OcclusionScene;
  /** For each mesh with normals, the occlusion of each vertex, from 0 (sees the whole sky) to 32767 (sees nothing of it). */
  occlusions: Int16Array<ArrayBuffer>[];
}

/** The normalised 16-bit integer that stands for 1. */
const ONE = 0x7fff;

/** The input of `addDirections`. */
export interface DirectionRequest {
  scene: OcclusionScene;
  /** The numbers of the pairs of opposite directions to add. */
  pairs: readonly number[];
  /** Sums of other copies of the scene, for other directions, which are added too. */
  sums?: readonly Float32Array<ArrayBuffer>[];
}

/**
 * Adds pairs of opposite directions to a bake: for each sample it sums the directions in which the sky is visible. The scene is rasterized
 * once per pair and view, for both directions and all samples.
 */
export function* addDirections({
  scene,
  pairs,
  sums = [],
}: DirectionRequest): Generator<number, OcclusionResult, void> {
  for (const others of sums) for (let i = 0; i < others.length; i++) scene.sums[i] += others[i];
  const maps = createDepthMaps(scene.positions.length / 3);
  const steps = pairs.length * scene.views.length;
  for (let step = 0; step < steps; step++) {
    const view = scene.views[step % scene.views.length];
    const axes = mapAxes(pairs[Math.floor(step / scene.views.length)]);
    const projection = projectionOf(axes, view);
    const from = step / steps;
    const to = (step + 1) / steps;
    yield* asPhase(drawDepths(maps, scene, projection), from, (from + to) / 2);
    yield* asPhase(
      forEachChunk(view.samples.length, (start, end) => lookUp(maps, scene, view, projection, start, end)),
      (from + to) / 2,
      to,
    );
  }
  return { scene, occlusions: scene.sampleOf.map((sampleOf) => occlusionsOf(scene.sums, sampleOf)) };
}

function lookUp(
  { highest, lowest }: DepthMaps,
  { samplePositions, sampleNormals, sums }: OcclusionScene,
  { samples }: OcclusionView,
  p: Projection,
  start: number,
  end: number,
): void {
  const size = MAP_SIZE;
  for (let i = start; i < end; i++) {
    const sample = samples[i];
    const at = 3 * sample;
    const cosine = p[8] * sampleNormals[at] + p[9] * sampleNormals[at + 1] + p[10] * sampleNormals[at + 2];
    const x = samplePositions[at];
    const y = samplePositions[at + 1];
    const z = samplePositions[at + 2];
    const column = Math.floor(p[0] * x + p[1] * y + p[2] * z + p[3]);
    const row = Math.floor(p[4] * x + p[5] * y + p[6] * z + p[7]);
    const depth = p[8] * x + p[9] * y + p[10] * z + p[11];
    const pixel = row * size + column;
    sums[2 * sample] += Math.abs(cosine);
    if (cosine > 0 ? !(highest[pixel] > depth) : !(lowest[pixel] < depth)) sums[2 * sample + 1] += Math.abs(cosine);
  }
}

function occlusionsOf(sums: Float32Array, sampleOf: Uint32Array): Int16Array<ArrayBuffer> {
  const occlusions = new Int16Array(sampleOf.length);
  for (let vertex = 0; vertex < sampleOf.length; vertex++) {
    const sample = sampleOf[vertex];
    if (sample === NO_SAMPLE) continue;
    const above = sums[2 * sample];
    if (above > 0) occlusions[vertex] = Math.round(ONE * (1 - sums[2 * sample + 1] / above));
  }
  return occlusions;
}
