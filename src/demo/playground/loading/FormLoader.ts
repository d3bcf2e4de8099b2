import { type BufferGeometry, MathUtils } from 'three';
import type { HatchedModel } from '../../../drawing/HatchedModel.js';
import type { Settings } from '../../../settings/settings.js';
import { formDrawn } from '../../../settings/settingValues.js';
import type { Stage } from '../../stage/Stage.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';

/** How long settings stay as they are before a form is baked anew, in milliseconds: a slider moves on. */
const REST = 150;

const LINES = 'laying lines along the form';
const STROKES = 'laying strokes along the form';

/** How a form is baked: across which axis, at which angle lines cross, and whether only for shapes that have one. */
interface Way extends Pick<Settings, 'upAxis' | 'crossAngle'> {
  auto: boolean;
}

/** Bakes what lines and strokes that follow the form are drawn from, when the settings ask for them. Until then they go by the light. */
export class FormLoader {
  /** The model and the way for which a bake was started, even if it failed or was cancelled. */
  private model: HatchedModel | undefined;
  private way: Way | undefined;
  /** The geometries that were made for the model, and are drawn. */
  private readonly made = new Set<BufferGeometry>();

  constructor(
    private readonly stage: Stage,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
  ) {}

  /** Whether a bake will start as soon as the model has been drawn without it. */
  get isAwaited(): boolean {
    const { model, shown, isLost } = this.stage;
    const drawn = formDrawn(this.settings);
    if (model === undefined || shown.isStandIn || isLost || !drawn) return false;
    const { settings, way } = this;
    const isBaked = model === this.model && way?.upAxis === settings.upAxis && way.auto === drawn.auto;
    // Strokes cross by turning.
    return !isBaked || (drawn.hasLines && way.crossAngle !== settings.crossAngle);
  }

  /** Starts a bake if one is needed. To be called when the model or the settings have changed, and when a picture is on the page. */
  update(): void {
    if (this.model && this.stage.model !== this.model) this.letGo();
    if (this.isAwaited && this.stage.quality.isOnPage) this.start();
  }

  /** For a picture, which lasts: resolves when lines lie as the settings ask, or when they could not be laid so. */
  async settled(signal: AbortSignal): Promise<void> {
    // Another model may be opened meanwhile.
    while ((this.isAwaited || this.tasks.isRunning('form')) && !signal.aborted) {
      if (this.isAwaited) this.start();
      await this.tasks.ended('form', signal);
    }
  }

  private start(): void {
    const { stage, settings } = this;
    const model = stage.model!;
    const isAnew = this.model === model;
    this.model = model;
    const { upAxis, crossAngle } = settings;
    const { auto, hasLines } = formDrawn(settings)!;
    this.way = { upAxis, crossAngle, auto };
    const form = { crossAngle: MathUtils.degToRad(crossAngle), auto };
    const what = hasLines ? LINES : STROKES;
    void this.tasks.run('form', async (report, signal) => {
      report(what);
      if (isAnew) await new Promise((resume) => setTimeout(resume, REST));
      signal.throwIfAborted();
      const { bakeForm } = await import('../../../drawing/bakeForm.js');
      signal.throwIfAborted();
      const onProgress = (progress: number): void => report(what, progress);
      stage.frames.keepPictures();
      try {
        await bakeForm(
          model.root,
          form,
          { signal, onProgress },
          (former, made) => this.exchange(former, made),
          // Lines along the form have programs of their own, for which a frame would wait.
          () => this.stage.rebuildPrograms(),
        );
      } finally {
        stage.frames.leavePictures();
      }
    });
  }

  /** Draws with another geometry in the next frame, or with the same one that has other lines. */
  private exchange(former: BufferGeometry, made: BufferGeometry): void {
    this.stage.frames.fadeIntoNext();
    if (made === former) return;
    this.made.add(made);
    if (this.made.delete(former)) former.dispose();
  }

  /** Stops the bake and disposes of what it made, because the model is gone. */
  private letGo(): void {
    this.tasks.stop('form');
    for (const geometry of this.made) geometry.dispose();
    this.made.clear();
    this.model = undefined;
    this.way = undefined;
  }
}
