import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { applyHatching } from 'three-hatching';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';
import { scannedTorus } from './scannedTorus.mjs';

/** Where the server of the benchmarks has meshoptimizer. */
const SIMPLIFIER = '/node_modules/meshoptimizer/meshopt_simplifier.js';

export interface DetailPlan {
  /** Of the large model. */
  triangles: number;
  /** Of the model that it is compared with. */
  reference: number;
  /** Of the canvas, in pixels per side. */
  sizes: readonly number[];
  turns: number;
}

/** Seconds to hatch the large model with its levels; and by size of the canvas the triangles of the level and the times of frames, one a turn. */
export interface DetailTimes {
  seconds: number;
  views: { size: number; drawn: number; times: Record<string, number[]> }[];
}

/** Draws a large model with levels and as a whole, and a smaller one, in turn. */
export async function measureDetail({ triangles, reference, sizes, turns }: DetailPlan): Promise<DetailTimes> {
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
  return { seconds, views };
}

function scan(triangles: number): Mesh {
  const { positions, indices } = scannedTorus(Math.round(Math.sqrt(triangles / 2)));
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(positions, 3));
  return new Mesh(geometry.setIndex(new BufferAttribute(indices, 1)));
}
