import { Mesh } from 'three';
import {
  bakeOcclusion,
  HatchingMaterial,
  type HatchingTechnique,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';

const WARM_UP_TURNS = 2;

export interface OcclusionTimes {
  triangles: number;
  /** Milliseconds until each result, for every bake. */
  passes: number[][];
  /** The longest task of the main thread during the bakes, in milliseconds; the browser reports no task below 50 ms. */
  longest: number;
  /** Frames by technique, milliseconds, one per turn. */
  times: Record<string, { open: number[]; occluded: number[] }>;
}

/** Bakes of a model, and frames of it without occlusion and with it. */
export async function measureOcclusion(
  model: string,
  repeats: number,
  turns: number,
  size: number,
): Promise<OcclusionTimes> {
  const plain = await loadModel(model);
  const triangles = plain.index!.count / 3;
  const tonalArtMap = await TonalArtMap.generate();
  const stage = new Stage(size);
  const passes: number[][] = [];
  let longest = 0;
  const observer = new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) longest = Math.max(longest, duration);
  });
  const times: OcclusionTimes['times'] = {};
  for (const [technique, layout] of [
    ['adjacency', 'corner'],
    ['hatching', 'indexed'],
    ['engraving', 'indexed'],
  ] satisfies [HatchingTechnique, 'corner' | 'indexed'][]) {
    const [open, occluded] = await Promise.all(
      [0, 1].map(async () => new Mesh(await prepareHatchingGeometry(plain, { layout }))),
    );
    open.material = occluded.material = new HatchingMaterial(plainLook({ tonalArtMap, technique }));
    observer.observe({ entryTypes: ['longtask'] });
    for (let i = 0; i < (technique === 'adjacency' ? repeats : 1); i++) {
      const reached: number[] = [];
      const start = performance.now();
      await bakeOcclusion(occluded, { onPass: () => void reached.push(performance.now() - start) });
      if (technique === 'adjacency') passes.push(reached);
    }
    observer.disconnect();
    const frames = { open: [] as number[], occluded: [] as number[] };
    for (let turn = -WARM_UP_TURNS; turn < turns; turn++) {
      // Every other turn backwards: what is drawn before may make a difference.
      for (const name of turn % 2 === 0 ? (['open', 'occluded'] as const) : (['occluded', 'open'] as const)) {
        const time = await stage.timeFrame(name === 'open' ? open : occluded);
        if (turn >= 0) frames[name].push(time);
      }
    }
    times[technique] = frames;
    open.geometry.dispose();
    occluded.geometry.dispose();
  }
  return { triangles, passes, longest, times };
}
