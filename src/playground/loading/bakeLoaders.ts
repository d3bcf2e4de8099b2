import { type BufferGeometry, MathUtils } from 'three';
import type { OcclusionBake } from 'three-hatching';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../viewer/drawing/meshes.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { drawsWithAdjacency, formDrawn } from '../../viewer/settings/settingValues.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { Viewport } from '../viewport/Viewport.js';

/** Pause before a form is baked again, in milliseconds, since a slider may move on. */
const REST = 150;

const ADJACENCY = 'joining triangles';
const LINES = 'laying lines along the form';
const STROKES = 'laying strokes along the form';

/** Parameters of a form bake: the up axis, the crossing angle, and whether only shapes with a clear form get lines. */
interface FormWay extends Pick<Settings, 'upAxis' | 'crossAngle'> {
  auto: boolean;
}

/**
 * Bakes form lines and triangle adjacency into the model's geometries when the settings need them. Until then, lines follow the light, and
 * techniques with adjacency are drawn as `hatching`.
 */
export class GeometryLoader {
  /** The model that was baked last, and for what, even if that failed or was cancelled. */
  private model: HatchedModel | undefined;
  private form: FormWay | undefined;
  private adjacency = false;
  /** The baked geometries in use. */
  private readonly made = new Set<BufferGeometry>();

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
  ) {}

  /** Whether a bake will start once the model has been drawn without it. */
  get isAwaited(): boolean {
    const { model, shown, isLost } = this.viewport;
    if (model === undefined || shown.isPlaceholder || isLost) return false;
    return this.isFormAwaited || this.isAdjacencyAwaited(model);
  }

  /** Starts a bake if one is needed. Call this after a change of model or settings, and when a picture is on the page. */
  update(): void {
    if (this.model && this.viewport.model !== this.model) this.letGo();
    // Asking again after a cancelled bake starts it again.
    if (!drawsWithAdjacency(this.settings)) this.adjacency = false;
    if (this.isAwaited && this.viewport.quality.isOnPage) this.start();
  }

  private get isFormAwaited(): boolean {
    const { settings, form } = this;
    const drawn = formDrawn(settings);
    if (!drawn) return false;
    const isBaked = this.viewport.model === this.model && form?.upAxis === settings.upAxis && form.auto === drawn.auto;
    // Only lines have a baked crossing angle; strokes cross by rotation.
    return !isBaked || (drawn.hasLines && form.crossAngle !== settings.crossAngle);
  }

  private isAdjacencyAwaited(model: HatchedModel): boolean {
    const isAsked = model === this.model && this.adjacency;
    return !isAsked && drawsWithAdjacency(this.settings) && model.lacksAdjacency;
  }

  /** For a saved picture: resolves when the form lines are baked for the settings, or have failed. */
  async settled(signal: AbortSignal): Promise<void> {
    // The model may change in the meantime.
    while ((this.isAwaited || this.tasks.isRunning('form')) && !signal.aborted) {
      if (this.isAwaited) this.start();
      await this.tasks.ended('form', signal);
    }
  }

  private start(): void {
    const { viewport, settings } = this;
    const model = viewport.model!;
    const isAnew = this.model === model;
    const adjacency = drawsWithAdjacency(settings) && model.lacksAdjacency;
    const drawn = formDrawn(settings);
    this.model = model;
    const { upAxis, crossAngle } = settings;
    // Geometries that get adjacency keep an earlier form.
    if (drawn) this.form = { upAxis, crossAngle, auto: drawn.auto };
    else if (!isAnew) this.form = undefined;
    this.adjacency ||= adjacency;
    const form = this.form && { crossAngle: MathUtils.degToRad(this.form.crossAngle), auto: this.form.auto };
    const what = !drawn ? ADJACENCY : drawn.hasLines ? LINES : STROKES;
    void this.tasks.run('form', async (report, signal) => {
      report(what);
      if (isAnew) await new Promise((resume) => setTimeout(resume, REST));
      signal.throwIfAborted();
      const { bakeFurther } = await import('../../viewer/drawing/bakeFurther.js');
      signal.throwIfAborted();
      const onProgress = (progress: number): void => report(what, progress);
      viewport.frames.keepPictures();
      try {
        await bakeFurther(
          model.root,
          { form, adjacency },
          { signal, onProgress },
          (former, made) => this.exchange(former, made),
          // Form lines need other programs, for which a frame would wait.
          () => this.viewport.rebuildPrograms(),
        );
        if (adjacency) viewport.reapply();
      } finally {
        viewport.frames.leavePictures();
      }
    });
  }

  /** Draws another geometry from the next frame on, or the same one with other lines. */
  private exchange(former: BufferGeometry, made: BufferGeometry): void {
    this.viewport.frames.fadeIntoNext();
    if (made === former) return;
    this.made.add(made);
    if (this.made.delete(former)) former.dispose();
  }

  /** Stops the bake and disposes of its results, because the model is gone. */
  private letGo(): void {
    this.tasks.stop('form');
    for (const geometry of this.made) geometry.dispose();
    this.made.clear();
    this.model = undefined;
    this.form = undefined;
    this.adjacency = false;
  }
}

const STAGE = 'darkening hollows';

/** Bakes the ambient occlusion of the shown model once, when the settings first need it. */
export class OcclusionLoader {
  /** The model that was baked last, even if that failed or was cancelled. */
  private model: HatchedModel | undefined;
  /** The parts of it that were hidden. */
  private hidden: readonly number[] | undefined;
  private bake: OcclusionBake | undefined;

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
  ) {}

  /** Whether a bake will start once the model has been drawn without occlusion. */
  get isAwaited(): boolean {
    const { model, isLost } = this.viewport;
    const isBaked = model === this.model && model?.parts?.hidden === this.hidden;
    return model !== undefined && !isBaked && !model.isOccluded && this.settings.occlusion > 0 && !isLost;
  }

  /**
   * Starts a bake if one is needed. Call this after a change of model or settings, and when a picture is on the page, because the bake must
   * not delay the first frame.
   */
  update(): void {
    // A placeholder is replaced before its bake could end.
    const model = this.viewport.shown.isPlaceholder ? undefined : this.viewport.model;
    // Hidden parts do not darken others.
    if (model !== this.model || model?.parts?.hidden !== this.hidden) this.letGo();
    if (!model || !this.isAwaited || !this.viewport.quality.isOnPage) return;
    this.model = model;
    this.hidden = model.parts?.hidden;
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
    this.hidden = undefined;
  }
}
