import { EDGE, mapAxes, type Projection, project, projectionOf } from '../parallelProjection.js';
import { asPhase, chunkPhase, forEachChunk } from '../phases.js';
import { MAP_SIZE, NO_SAMPLE, type OcclusionScene, type OcclusionView } from './OcclusionScene.js';
import { packedSide, packedSides } from './occlusionSides.js';

/** The result of `addDirections`. */
export interface OcclusionResult {
  scene: OcclusionScene;
  /** For each mesh with normals, the component of `hatchNormal` that holds the occlusion of each vertex (`occlusionSides.ts`). */
  occlusions: Int16Array<ArrayBuffer>[];
}

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
    const projection = projectionOf(axes, view, MAP_SIZE);
    const from = step / steps;
    const to = (step + 1) / steps;
    yield* asPhase(drawDepths(maps, scene, projection), from, (from + to) / 2);
    yield* chunkPhase(view.samples.length, (from + to) / 2, to, (start, end) =>
      lookUp(maps, scene, view, projection, start, end),
    );
  }
  const occlusionAt = occlusionIn(scene);
  return {
    scene,
    occlusions: scene.sampleOf.map((sampleOf, i) => occlusionsOf(occlusionAt, sampleOf, scene.backAfter[i])),
  };
}

function lookUp(
  { highest, lowest }: DepthMaps,
  { samplePositions, sampleNormals, standsFor, sums }: OcclusionScene,
  { samples }: OcclusionView,
  p: Projection,
  start: number,
  end: number,
): void {
  const size = MAP_SIZE;
  const vertices = samplePositions.length / 3 - standsFor.length;
  for (let i = start; i < end; i++) {
    const sample = samples[i];
    const vertex = sample < vertices ? sample : standsFor[sample - vertices];
    const cosine =
      p[8] * sampleNormals[3 * vertex] + p[9] * sampleNormals[3 * vertex + 1] + p[10] * sampleNormals[3 * vertex + 2];
    const x = samplePositions[3 * sample];
    const y = samplePositions[3 * sample + 1];
    const z = samplePositions[3 * sample + 2];
    const column = Math.floor(p[0] * x + p[1] * y + p[2] * z + p[3]);
    const row = Math.floor(p[4] * x + p[5] * y + p[6] * z + p[7]);
    const depth = p[8] * x + p[9] * y + p[10] * z + p[11];
    const pixel = row * size + column;
    sums[2 * vertex] += Math.abs(cosine);
    if (cosine > 0 ? !(highest[pixel] > depth) : !(lowest[pixel] < depth)) sums[2 * vertex + 1] += Math.abs(cosine);
  }
}

type OcclusionAt = (sample: number) => number;

function occlusionsOf(occlusionAt: OcclusionAt, sampleOf: Uint32Array, backAfter: number): Int16Array<ArrayBuffer> {
  const occlusions = new Int16Array(sampleOf.length);
  for (let vertex = 0; vertex < sampleOf.length; vertex++) {
    const sample = sampleOf[vertex];
    if (sample === NO_SAMPLE) continue;
    const one = occlusionAt(sample);
    occlusions[vertex] = backAfter === 0 ? packedSide(one) : packedSides(one, occlusionAt(sample + backAfter));
  }
  return occlusions;
}

/** The occlusion from which on a vertex may be buried in a body; at 1 it is. */
const BURIED = 0.9;

/**
 * The occlusion of a sample of a vertex: the share of the directions above it in which the sky is hidden, weighted by their cosines. A stand-in
 * counts beside its vertex. A vertex that is buried in a body has the occlusion of its stand-in, which is seen.
 */
function occlusionIn({ sums, standIns, samplePositions, standsFor }: OcclusionScene): OcclusionAt {
  const hiddenAt = (...samples: readonly number[]): number => {
    let [above, visible] = [0, 0];
    for (const sample of samples) {
      above += sums[2 * sample];
      visible += sums[2 * sample + 1];
    }
    return above > 0 ? 1 - visible / above : 0;
  };
  const vertices = samplePositions.length / 3 - standsFor.length;
  const ofVertices = new Map(Array.from(standIns, (vertex, i) => [vertex, i]));
  return (sample) => {
    const own = hiddenAt(sample);
    const i = ofVertices.get(sample);
    if (i === undefined) return own;
    const within = vertices + i;
    const seen = hiddenAt(sample, within);
    return seen + Math.max(0, (own - BURIED) / (1 - BURIED)) * (hiddenAt(within) - seen);
  };
}

/** The depth maps of a pair of opposite directions. Depth grows towards the first of the two skies. */
interface DepthMaps {
  /** The greatest depth at the middle of each pixel, as seen from the first sky; −∞ where there is nothing. */
  highest: Float32Array;
  /** The least depth at the middle of each pixel, as seen from the opposite sky; ∞ where there is nothing. */
  lowest: Float32Array;
  /** x, y in pixels and depth of each vertex. */
  projected: Float32Array;
}

/** Creates depth maps for a scene with this number of vertices. */
const createDepthMaps = (vertices: number): DepthMaps => ({
  highest: new Float32Array(MAP_SIZE * MAP_SIZE),
  lowest: new Float32Array(MAP_SIZE * MAP_SIZE),
  projected: new Float32Array(3 * vertices),
});

/** Rasterizes all triangles for both skies at once; those with one side only for the sky that sees it. */
function* drawDepths(
  maps: DepthMaps,
  { positions, indices, twoSided }: OcclusionScene,
  projection: Projection,
): Generator<number, void, void> {
  maps.highest.fill(-Infinity);
  maps.lowest.fill(Infinity);
  yield* forEachChunk(positions.length / 3, (start, end) => project(positions, maps.projected, projection, start, end));
  yield* forEachChunk(indices.length / 3, (start, end) => drawTriangles(maps, indices, twoSided, start, end));
}

function drawTriangles(
  { highest, lowest, projected }: DepthMaps,
  indices: Uint32Array,
  twoSided: number,
  start: number,
  end: number,
): void {
  const size = MAP_SIZE;
  const last = size - 1;
  const edge = EDGE;
  const most = 1 - edge;
  for (let corner = 3 * start; corner < 3 * end; corner += 3) {
    const a = 3 * indices[corner];
    const b = 3 * indices[corner + 1];
    const c = 3 * indices[corner + 2];
    const ax = projected[a];
    const ay = projected[a + 1];
    const bx = projected[b] - ax;
    const by = projected[b + 1] - ay;
    const cx = projected[c] - ax;
    const cy = projected[c + 1] - ay;
    const left = Math.max(0, Math.ceil(ax + Math.min(0, bx, cx) - 0.5));
    const right = Math.min(last, Math.floor(ax + Math.max(0, bx, cx) - 0.5));
    if (!(left <= right)) continue;
    const bottom = Math.max(0, Math.ceil(ay + Math.min(0, by, cy) - 0.5));
    const top = Math.min(last, Math.floor(ay + Math.max(0, by, cy) - 0.5));
    if (!(bottom <= top)) continue;
    const area = bx * cy - by * cx;
    if (area === 0) continue;
    const isTwoSided = corner < 3 * twoSided;
    const isHigh = isTwoSided || area > 0;
    const isLow = isTwoSided || area < 0;
    // The barycentric weights of b and c at the middle of the first pixel, and how they change to the right and upwards.
    const perArea = 1 / area;
    const rightB = cy * perArea;
    const rightC = -by * perArea;
    const upB = -cx * perArea;
    const upC = bx * perArea;
    const px = left + 0.5 - ax;
    const py = bottom + 0.5 - ay;
    let rowB = px * rightB + py * upB;
    let rowC = px * rightC + py * upC;
    const az = projected[a + 2];
    const bz = projected[b + 2] - az;
    const cz = projected[c + 2] - az;
    const width = right - left;
    for (let row = bottom * size + left; row <= top * size + left; row += size) {
      let shareB = rowB;
      let shareC = rowC;
      for (let pixel = row; pixel <= row + width; pixel++) {
        if (shareB >= edge && shareC >= edge && shareB + shareC <= most) {
          const depth = az + shareB * bz + shareC * cz;
          if (isHigh && depth > highest[pixel]) highest[pixel] = depth;
          if (isLow && depth < lowest[pixel]) lowest[pixel] = depth;
        }
        shareB += rightB;
        shareC += rightC;
      }
      rowB += upB;
      rowC += upC;
    }
  }
}
