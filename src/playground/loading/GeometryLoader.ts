import { type BufferGeometry, MathUtils } from 'three';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { drawsWithAdjacency, formDrawn } from '../../viewer/settings/settingValues.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { Viewport } from '../viewport/Viewport.js';

/** How long settings stay as they are before a form is baked anew, in milliseconds: a slider moves on. */
const REST = 150;

const ADJACENCY = 'joining triangles';
const LINES = 'laying lines along the form';
const STROKES = 'laying strokes along the form';

/** How a form is baked: across which axis, at which angle lines cross, and whether only for shapes that have one. */
interface FormWay extends Pick<Settings, 'upAxis' | 'crossAngle'> {
  auto: boolean;
}

/**
 * Bakes what the settings ask for into the geometries of the model: what lines and strokes that follow the form are drawn from, and
 * triangle adjacency. Until then lines and strokes go by the light, and techniques with adjacency are drawn as `anchored`.
 */
export class GeometryLoader {
  /** The model for which a bake was started, and of what, even if it failed or was cancelled. */
  private model: HatchedModel | undefined;
  private form: FormWay | undefined;
  private adjacency = false;
  /** The geometries that were made for the model, and are drawn. */
  private readonly made = new Set<BufferGeometry>();

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
  ) {}

  /** Whether a bake will start as soon as the model has been drawn without it. */
  get isAwaited(): boolean {
    const { model, shown, isLost } = this.viewport;
    if (model === undefined || shown.isStandIn || isLost) return false;
    return this.isFormAwaited || this.isAdjacencyAwaited(model);
  }

  /** Starts a bake if one is needed. To be called when the model or the settings have changed, and when a picture is on the page. */
  update(): void {
    if (this.model && this.viewport.model !== this.model) this.letGo();
    // Who asks for it again after it was cancelled, gets it.
    if (!drawsWithAdjacency(this.settings)) this.adjacency = false;
    if (this.isAwaited && this.viewport.quality.isOnPage) this.start();
  }

  private get isFormAwaited(): boolean {
    const { settings, form } = this;
    const drawn = formDrawn(settings);
    if (!drawn) return false;
    const isBaked = this.viewport.model === this.model && form?.upAxis === settings.upAxis && form.auto === drawn.auto;
    // Strokes cross by turning.
    return !isBaked || (drawn.hasLines && form.crossAngle !== settings.crossAngle);
  }

  private isAdjacencyAwaited(model: HatchedModel): boolean {
    const isAsked = model === this.model && this.adjacency;
    return !isAsked && drawsWithAdjacency(this.settings) && model.lacksAdjacency;
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
    const { viewport, settings } = this;
    const model = viewport.model!;
    const isAnew = this.model === model;
    const adjacency = drawsWithAdjacency(settings) && model.lacksAdjacency;
    const drawn = formDrawn(settings);
    this.model = model;
    const { upAxis, crossAngle } = settings;
    // Geometries that get adjacency keep a form that was baked before.
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
          // Lines along the form have programs of their own, for which a frame would wait.
          () => this.viewport.rebuildPrograms(),
        );
        if (adjacency) viewport.reapply();
      } finally {
        viewport.frames.leavePictures();
      }
    });
  }

  /** Draws with another geometry in the next frame, or with the same one that has other lines. */
  private exchange(former: BufferGeometry, made: BufferGeometry): void {
    this.viewport.frames.fadeIntoNext();
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
    this.form = undefined;
    this.adjacency = false;
  }
}
