import { asPhase, forEachChunk, release } from '../phases.js';
import { assembleHeatEquation, type FanSurface, type HeatEquation } from './assembleHeatEquation.js';
import { diffuse, isFar } from './diffuse.js';
import { meanNormals } from './fanNormals.js';
import { sortFans } from './fans.js';
import { highestRate } from './heatFlow.js';

/**
 * Smooths normals at the scale of each of `radii`, in object units. The mean normal of each fan diffuses over the surface like
 * heat, for the time radius²/4, in which heat spreads over about `radius`. Finer noise is averaged away; nothing flows across
 * edges that separate fans. The result depends on the shape and not on its triangulation, thanks to cotangent weights and a
 * time in object units instead of a number of passes.
 *
 * Several radii cost little more than the largest of them, because they are parts of one flow.
 *
 * @param shares for each fan the share of the radii that is used around it, at most 1. Default: 1 everywhere
 * @returns for each radius a vector per fan (x, y, z), not of unit length. It is zero where normals cancel and for fans that
 *   only have degenerate triangles.
 */
export function* smoothFanNormals(
  surface: FanSurface,
  radii: readonly number[],
  shares?: Float32Array,
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const { order, normals, heat } = yield* asPhase(startFlow(surface), 0, 0.25);
  const times = radii.map((radius) => radius ** 2 / 4);
  const rate = highestRate(heat);
  const places = times.some((time) => isFar(time * rate)) ? placesOf(surface, order) : undefined;
  const level = { heat, places, shares: shares && gathered(shares, order) };
  const results = yield* asPhase(diffuse(level, normals, times), 0.25, 0.98);
  release(heat.starts, heat.neighbours, heat.weights, heat.masses, heat.degrees);
  return yield* asPhase(inOrderOfFans(results, order), 0.98, 1);
}

/** The mean normal of each fan, three floats, and the heat equation that smooths them. */
interface NormalFlow {
  normals: Float32Array<ArrayBuffer>;
  heat: HeatEquation;
}

/** Prepares the flow; temporary data is freed on return. `order` is that of `sortFans`. */
function* startFlow(surface: FanSurface): Generator<number, NormalFlow & { order: Uint32Array<ArrayBuffer> }, void> {
  const sorted = yield* asPhase(sortFans(surface), 0, 0.2);
  const { normals, masses } = yield* asPhase(meanNormals(surface, sorted), 0.2, 0.4);
  const heat = yield* asPhase(assembleHeatEquation(surface, masses, sorted), 0.4, 1);
  release(sorted.numbers);
  return { order: sorted.order, normals, heat };
}

/** The position of each of the sorted fans. */
function placesOf({ mesh: { positions, indices }, fans }: FanSurface, order: Uint32Array): Float32Array {
  const vertices = new Uint32Array(fans.count);
  for (let corner = 0; corner < indices.length; corner++) vertices[fans.ofCorner[corner]] = indices[corner];
  const places = new Float32Array(3 * fans.count);
  for (let i = 0; i < order.length; i++) {
    const vertex = 3 * vertices[order[i]];
    for (let k = 0; k < 3; k++) places[3 * i + k] = positions[vertex + k];
  }
  return places;
}

const gathered = (values: Float32Array, order: Uint32Array): Float32Array<ArrayBuffer> => {
  const result = new Float32Array(values.length);
  for (let i = 0; i < values.length; i++) result[i] = values[order[i]];
  return result;
};

/** Puts vectors back into the order of the fans before sorting. Radii that share a result still share it. */
function* inOrderOfFans(
  results: readonly Float32Array[],
  order: Uint32Array,
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const targets = new Map<Float32Array, Float32Array<ArrayBuffer>>();
  for (const result of new Set(results)) {
    const target = new Float32Array(result.length);
    targets.set(result, target);
    yield* forEachChunk(order.length, (start, end) => scatterVectors(result, order, target, start, end));
    release(result);
  }
  release(order);
  return results.map((result) => targets.get(result)!);
}

function scatterVectors(
  vectors: Float32Array,
  order: Uint32Array,
  target: Float32Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const fan = 3 * order[i];
    target[fan] = vectors[3 * i];
    target[fan + 1] = vectors[3 * i + 1];
    target[fan + 2] = vectors[3 * i + 2];
  }
}
