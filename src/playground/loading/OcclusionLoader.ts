import type { OcclusionBake } from 'three-hatching';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../viewer/drawing/meshesOf.js';
import type { Settings } from '../../viewer/settings/settings.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { Viewport } from '../viewport/Viewport.js';

const STAGE = 'darkening hollows';

/** Bakes the ambient occlusion of the shown model once, when the settings first need it. */
export class OcclusionLoader {
  /** The model that was baked last, even if that failed or was cancelled. */
  private model: HatchedModel | undefined;
  private bake: OcclusionBake | undefined;

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
  ) {}

  /** Whether a bake will start once the model has been drawn without occlusion. */
  get isAwaited(): boolean {
    const { model, isLost } = this.viewport;
    return model !== undefined && model !== this.model && !model.isOccluded && this.settings.occlusion > 0 && !isLost;
  }

  /**
   * Starts a bake if one is needed. Call this after a change of model or settings, and when a picture is on the page, because the bake must
   * not delay the first frame.
   */
  update(): void {
    // A placeholder is replaced before its bake could end.
    const model = this.viewport.shown.isPlaceholder ? undefined : this.viewport.model;
    if (model !== this.model) this.letGo();
    if (!model || !this.isAwaited || !this.viewport.quality.isOnPage) return;
    this.model = model;
    // Occlusion is stored per vertex, and instances share their vertices.
    if (meshesOf(model.root).every((mesh) => 'isInstancedMesh' in mesh)) return;
    void this.tasks.run('occlusion', async (report, signal) => {
      report(STAGE);
      const { bakeOcclusion } = await import('../../viewer/drawing/bakeOcclusion.js');
      signal.throwIfAborted();
      const bake = await bakeOcclusion(model.root, {
        signal,
        onProgress: (progress) => report(STAGE, progress),
        onPass: () => {
          if (!this.viewport.quality.isSlow) this.viewport.frames.refine();
        },
        // Other tasks are more urgent, and a picture being saved must not change.
        pause: () => this.tasks.others('occlusion', signal),
      });
      if (signal.aborted) bake.dispose();
      else this.bake = bake;
      this.viewport.frames.refine();
    });
  }

  /** Stops the bake and disposes of its result, because the model is gone. */
  private letGo(): void {
    this.tasks.stop('occlusion');
    this.bake?.dispose();
    this.bake = undefined;
    this.model = undefined;
  }
}
