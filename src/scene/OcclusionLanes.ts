import type { OcclusionScene } from '../mesh/occlusion/OcclusionScene.js';
import { runSliced } from '../mesh/runSliced.js';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';

/** The number of pairs of opposite directions in one request to a worker. */
const PAIRS_AT_ONCE = 8;

/** A copy of the scene to which one worker adds directions. */
interface Lane {
  scene: OcclusionScene;
  /** The pairs of directions in its sums. */
  held: number[];
  /** The number of pairs added in total, including a fraction of those that are being added. */
  added: number;
}

/** The parts of the bake that lanes call. */
export interface OcclusionLanesHost {
  options: Pick<TaskOptions, 'signal' | 'createWorker'>;
  /** Makes the scene again, after it was lost with a worker that has died. */
  start(): Promise<OcclusionScene>;
  /** Called before each part of the work, which waits for the promise. */
  rest(): Promise<void>;
  /** Called with the number of pairs that have been added. It never falls. */
  onAdded?: ((pairs: number) => void) | undefined;
}

/**
 * Adds the directions of a bake in several workers at once. Each has a copy of the scene and directions of its own; their sums are
 * merged for every result.
 */
export class OcclusionLanes {
  private readonly lanes: Lane[];
  private reported = 0;
  /** The number of pairs in the latest result. */
  private done = 0;
  private hasFailed = false;

  private constructor(
    scenes: readonly OcclusionScene[],
    private readonly host: OcclusionLanesHost,
  ) {
    this.lanes = scenes.map((scene) => ({ scene, held: [], added: 0 }));
  }

  /**
   * Copies the scene for each worker, one copy at a time, since each may take many megabytes.
   *
   * @param count the number of workers
   */
  static async of(scene: OcclusionScene, count: number, host: OcclusionLanesHost): Promise<OcclusionLanes> {
    return new OcclusionLanes(await runSliced(copies(scene, count), { signal: host.options.signal }), host);
  }

  /**
   * Adds pairs up to a number.
   *
   * @returns for each mesh with normals, the occlusion of each vertex, as `addDirections` has it
   */
  async addUpTo(goal: number): Promise<Int16Array<ArrayBuffer>[]> {
    const { lanes, done } = this;
    const parts: number[][] = [];
    for (let from = done; from < goal; from += PAIRS_AT_ONCE)
      parts.push(Array.from({ length: Math.min(PAIRS_AT_ONCE, goal - from) }, (_, i) => from + i));
    // The distribution of pairs to lanes is fixed beforehand, so that the same machine always gets the same sums.
    const results = await Promise.all(
      lanes.map((lane, k) =>
        this.addIn(
          lane,
          parts.filter((_, part) => part % lanes.length === k),
        ),
      ),
    );
    this.done = goal;
    return lanes.length === 1 ? results[0] : this.together(goal);
  }

  /** Adds parts to one lane, one after the other. */
  private async addIn(lane: Lane, parts: readonly number[][]): Promise<Int16Array<ArrayBuffer>[]> {
    let occlusions: Int16Array<ArrayBuffer>[] = [];
    try {
      for (const pairs of parts) {
        await this.host.rest();
        // The failure of one lane fails all.
        if (this.hasFailed) break;
        occlusions = await this.add(lane, pairs);
      }
    } catch (error) {
      this.hasFailed = true;
      throw error;
    }
    return occlusions;
  }

  private async add(lane: Lane, pairs: readonly number[]): Promise<Int16Array<ArrayBuffer>[]> {
    const { host } = this;
    const { added } = lane;
    const onProgress = (progress: number): void => {
      lane.added = added + progress * pairs.length;
      this.report();
    };
    const { scene, occlusions } = await runTask(
      'addDirections',
      { scene: lane.scene, pairs },
      { ...host.options, ...(host.onAdded && { onProgress }) },
      // All directions so far are lost with the worker, so they are added again.
      async () => ({ scene: await host.start(), pairs: [...lane.held, ...pairs] }),
    );
    lane.scene = scene;
    lane.held.push(...pairs);
    lane.added = added + pairs.length;
    return occlusions;
  }

  /** Merges the sums of all lanes into those of the first. */
  private async together(goal: number): Promise<Int16Array<ArrayBuffer>[]> {
    const { host } = this;
    const [first, ...others] = this.lanes;
    const sums = others.map(({ scene }) => scene.sums);
    for (const lane of others) {
      lane.scene.sums = new Float32Array(lane.scene.sums.length);
      lane.held = [];
    }
    const all = Array.from({ length: goal }, (_, i) => i);
    const { scene, occlusions } = await runTask(
      'addDirections',
      { scene: first.scene, pairs: [], sums },
      host.options,
      async () => ({
        scene: await host.start(),
        pairs: all,
      }),
    );
    Object.assign(first, { scene, held: all });
    return occlusions;
  }

  private report(): void {
    const added = this.lanes.reduce((sum, lane) => sum + lane.added, 0);
    if (added <= this.reported) return;
    this.reported = added;
    this.host.onAdded?.(added);
  }
}

/** Yields the scene, and copies of it. */
function* copies(scene: OcclusionScene, count: number): Generator<number, OcclusionScene[], void> {
  const scenes = [scene];
  while (scenes.length < count) {
    scenes.push(structuredClone(scene));
    yield scenes.length / count;
  }
  return scenes;
}
