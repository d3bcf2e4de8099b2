import type { OcclusionBake } from 'three-hatching';
import type { HatchedModel } from '../../drawing/HatchedModel.js';
import { meshesOf } from '../../drawing/meshesOf.js';
import type { Settings } from '../../settings/settings.js';
import type { Stage } from '../../stage/Stage.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';

const STAGE = 'darkening hollows';

/** Bakes the occlusion of the model that is shown, once, when the settings first ask for it. */
export class OcclusionLoader {
  /** The model that was baked, also if that failed or was cancelled. */
  private model: HatchedModel | undefined;
  private bake: OcclusionBake | undefined;

  constructor(
    private readonly stage: Stage,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
  ) {}

  /** Whether it will be baked when the model has been drawn without. */
  get isAwaited(): boolean {
    const { model, isLost } = this.stage;
    return model !== undefined && model !== this.model && this.settings.occlusion > 0 && !isLost;
  }

  /** To be called when the model or the settings have changed, or the time of a frame is known: it does not delay the first. */
  update(): void {
    // A stand-in is gone before its occlusion were there.
    const model = this.stage.shown.isStandIn ? undefined : this.stage.model;
    if (model !== this.model) this.letGo();
    if (!model || !this.isAwaited || this.stage.quality.milliseconds === undefined) return;
    this.model = model;
    // All instances share their vertices, so there is no place to keep the occlusion of each.
    if (meshesOf(model.root).every((mesh) => 'isInstancedMesh' in mesh)) return;
    void this.tasks.run('occlusion', async (report, signal) => {
      report(STAGE);
      const { bakeOcclusion } = await import('../../drawing/bakeOcclusion.js');
      signal.throwIfAborted();
      const bake = await bakeOcclusion(model.root, {
        signal,
        onProgress: (progress) => report(STAGE, progress),
        onPass: () => this.stage.frames.invalidate(),
        // The hollows can wait, and a picture that is being saved must not change.
        pause: () => this.tasks.others('occlusion', signal),
      });
      if (signal.aborted) bake.dispose();
      else this.bake = bake;
    });
  }

  /** Stops, and keeps nothing of a model that is gone. */
  private letGo(): void {
    this.tasks.stop('occlusion');
    this.bake?.dispose();
    this.bake = undefined;
    this.model = undefined;
  }
}
