import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { applyHatching } from 'three-hatching';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';
import { scannedTorus } from './scannedTorus.mjs';

/** The URL of meshoptimizer on the server of the benchmarks. */
const SIMPLIFIER = '/node_modules/meshoptimizer/meshopt_simplifier.js';

export interface DetailPlan {
  /** Triangles of the large model. */
  triangles: number;
  /** Triangles of the model that it is compared with. */
  reference: number;
  /** Side of the canvas, pixels. */
  sizes: readonly number[];
  turns: number;
  /** The canvas and the steps of a way away from the model, in which flips are counted. */
  zoom: { size: number; steps: number };
}

/** Pixels that change more than by a shade while the camera moves away from a model, step by step. */
export interface Flips {
  levels: number;
  whole: number;
  steps: number;
}

/** Seconds to hatch the large model with its levels; and by size of the canvas the triangles of the level and the times of frames, one a turn. */
export interface DetailTimes {
  seconds: number;
  views: { size: number; drawn: number; times: Record<string, number[]> }[];
  /** Flips in all steps, and in those in which the level changes. */
  flips: { all: Flips; replacing: Flips };
}

/** The share of its distance by which the camera moves away in a step. */
const STEP = 0.03;
/** A pixel that changes by more than so many shades has flipped. */
const SHADES = 32;

/** Draws a large model with levels and as a whole, and a smaller one, in turn. */
export async function measureDetail({ triangles, reference, sizes, turns, zoom }: DetailPlan): Promise<DetailTimes> {
  const [levels, whole, smaller] = [triangles, triangles, reference].map(scan);
  const start = performance.now();
  await applyHatching(levels, { detail: { simplifier: SIMPLIFIER } });
  const seconds = (performance.now() - start) / 1000;
  for (const mesh of [whole, smaller]) await applyHatching(mesh, {});
  let drawn = 0;
  const { onBeforeRender } = levels;
  levels.onBeforeRender = (...all) => {
    onBeforeRender.apply(levels, all);
    const { drawRange, index } = levels.geometry;
    drawn = Math.min(drawRange.count, index!.count) / 3;
  };
  const views: DetailTimes['views'] = [];
  for (const size of sizes) {
    const times = await timeTurns(new Stage(size), { levels, whole, smaller }, turns);
    views.push({ size, drawn, times });
  }
  const flips = countFlips(new Stage(zoom.size), { levels, whole }, zoom.steps, () => drawn);
  return { seconds, views, flips };
}

/** Counts flips on the way from a model. @param level of the frame that was drawn last */
function countFlips(
  stage: Stage,
  { levels, whole }: Record<'levels' | 'whole', Mesh>,
  steps: number,
  level: () => number,
): DetailTimes['flips'] {
  const counts = { all: { levels: 0, whole: 0, steps: 0 }, replacing: { levels: 0, whole: 0, steps: 0 } };
  const draw = () => ({ whole: stage.readFrame(whole), levels: stage.readFrame(levels), level: level() });
  let before = draw();
  for (let step = 0; step < steps; step++) {
    stage.moveAway(1 + STEP);
    const after = draw();
    const [flips, wholeFlips] = [changed(before.levels, after.levels), changed(before.whole, after.whole)];
    for (const count of before.level === after.level ? [counts.all] : [counts.all, counts.replacing]) {
      count.levels += flips;
      count.whole += wholeFlips;
      count.steps++;
    }
    before = after;
  }
  return counts;
}

/** The number of pixels that differ between two pictures by more than a shade. */
function changed(one: Uint8Array, other: Uint8Array): number {
  let count = 0;
  for (let i = 0; i < one.length; i += 4) {
    if ([0, 1, 2].some((channel) => Math.abs(one[i + channel] - other[i + channel]) > SHADES)) count++;
  }
  return count;
}

function scan(triangles: number): Mesh {
  const { positions, indices } = scannedTorus(Math.round(Math.sqrt(triangles / 2)));
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(positions, 3));
  return new Mesh(geometry.setIndex(new BufferAttribute(indices, 1)));
}
