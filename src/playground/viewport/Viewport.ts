import type { BufferGeometry } from 'three';
import type { TonalArtMap } from 'three-hatching';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { WHOLE_SHEET } from '../../viewer/sceneSetup/fadeOnSheet.js';
import type { LensCamera } from '../../viewer/sceneSetup/LensCamera.js';
import type { Look } from '../../viewer/settings/lookOf.js';
import { ContextLoss } from './ContextLoss.js';
import { FrameQuality } from './FrameQuality.js';
import { Frames } from './Frames.js';
import { Painter } from './Painter.js';
import { Scenery } from './Scenery.js';
import type { ModelChange, ShownModel } from './ShownModel.js';
import { View } from './view/View.js';

/** The drawing on the page: what is drawn, where the camera is, and the frames and pictures that are drawn of it. */
export class Viewport {
  readonly scenery: Scenery;
  readonly camera: LensCamera;
  readonly view: View;
  readonly frames: Frames;
  readonly quality: FrameQuality;
  readonly painter: Painter;
  /** How often the view, the model or the look has changed, or the size of the viewport. */
  changes = 0;
  /** A finer geometry of the model, of which pictures are drawn instead of what frames show. The model is a single mesh then. */
  finer: BufferGeometry | undefined;
  private readonly contextLoss: ContextLoss;

  /** Sets up the viewport. A frame is drawn when one was requested, and when the viewport changes its size. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly context: WebGL2RenderingContext,
    private readonly viewport: HTMLElement,
  ) {
    const invalidate = (): void => this.frames.invalidate();
    this.scenery = new Scenery(invalidate, (change, firstView) => this.modelChanged(change, firstView));
    const { scenery } = this;
    this.painter = new Painter(canvas, context, viewport, scenery, () => this.frames.refine());
    const { painter } = this;
    this.camera = painter.camera;
    this.quality = new FrameQuality(painter.renderer, {
      refine: () => this.frames.refine(),
      isStandIn: () => scenery.shown.isStandIn,
      onSketched: () => {
        painter.outdateShadows();
        this.show();
      },
    });
    this.frames = new Frames(painter, scenery, this.quality, viewport);
    this.view = new View(
      canvas,
      this.camera,
      () => {
        this.changes++;
        invalidate();
      },
      (outline, toEye) => scenery.shadowOf(outline, toEye),
    );
    painter.sheetOf = () => this.view.sheet ?? WHOLE_SHEET;
    this.contextLoss = new ContextLoss(painter, scenery, this.frames, this.quality);
    new ResizeObserver(() => this.resize()).observe(viewport);
    this.resize();
  }

  /** The model that is shown, and how another one takes its place. */
  get shown(): ShownModel {
    return this.scenery.shown;
  }

  get model(): HatchedModel | undefined {
    return this.scenery.shown.model;
  }

  /** Draws in another look. This is cheap: at most a program is compiled, where the look needs another one. */
  apply(look: Look): void {
    this.scenery.look = look;
    this.changes++;
    this.show();
    this.painter.outdateShadows();
  }

  /** Draws in the same look again, because the geometries of the model can be drawn otherwise now, with other programs. */
  reapply(): void {
    const { look } = this.scenery;
    if (!look) return;
    this.painter.forgetPrograms();
    this.apply(look);
  }

  get tonalArtMap(): TonalArtMap | undefined {
    return this.scenery.tonalArtMap;
  }

  set tonalArtMap(map: TonalArtMap) {
    this.scenery.tonalArtMap = map;
    this.changes++;
    this.frames.invalidate();
  }

  /**
   * Shows the compared technique left of a divider. `share` returns its place in every frame; undefined ends the
   * comparison.
   */
  compareWith(share: (() => number) | undefined): void {
    this.painter.sides.divider = share;
    this.frames.invalidate();
  }

  /** Has the shadow maps drawn anew in the next frame, because a light or the model has moved. */
  outdateShadows(): void {
    this.painter.outdateShadows();
  }

  /** Whether there is a model, and a map if the look needs one. */
  get isComplete(): boolean {
    return this.scenery.isComplete;
  }

  /** Whether the graphics context is lost. What is changed meanwhile is drawn when it comes back. */
  get isLost(): boolean {
    return this.painter.isLost;
  }

  /** Whether the page shows the last picture from before the context was lost. */
  get showsLastPicture(): boolean {
    return this.contextLoss.showsLastPicture;
  }

  /**
   * Builds the programs of the first model while it is loaded. To be called when all techniques can be drawn. Programs that draw with a map
   * are not built without one.
   */
  async buildAhead(): Promise<void> {
    // Without this part, the first frame builds its programs itself.
    const part = await import('./makeForerunner.js').catch(() => undefined);
    const { shown, look } = this.scenery;
    if (!part || shown.drawn || this.isLost || !look || look.needsMap) return;
    shown.setForerunner(part.makeForerunner());
    this.show();
  }

  /** Draws a frame when the programs are built that other geometries of the model ask for. */
  rebuildPrograms(): void {
    const { painter, scenery, quality } = this;
    painter.forgetPrograms();
    if (scenery.look && !quality.isSketch && !this.frames.screen) painter.buildPrograms(scenery.look);
    this.frames.refine();
  }

  /** Shows the scenery in its look. */
  private show(): void {
    const { scenery, painter, view } = this;
    const { look } = scenery;
    if (!look) return;
    const { isTurned, hasOtherShadow } = scenery.apply(look);
    if (isTurned) {
      painter.outdateShadows();
      this.placeModel();
    } else if (hasOtherShadow && view.isFramed) view.frame();
    painter.setPaper(look.paper);
    // A sketch needs few programs, and its own frame builds them.
    if (!this.quality.isSketch && !this.frames.screen) painter.buildPrograms(look);
    this.frames.invalidate();
  }

  private modelChanged(change: ModelChange, firstView: readonly [number, number, number]): void {
    const { painter, frames } = this;
    this.changes++;
    painter.forgetPrograms();
    // A sketch has no shadows.
    const hasShadows = change === 'completed' && !this.quality.isSketch;
    // After a stand-in, no sketch is needed: programs are those of the model already, and shadows if it was drawn whole.
    this.quality.restart(change === 'another' && !painter.isLost);
    if (!hasShadows) painter.outdateShadows();
    if (change === 'back') frames.forgetStandIn();
    this.show();
    this.placeModel(firstView);
    frames.invalidate();
  }

  /** Puts the ground under the model, and frames it if the one before was framed. */
  private placeModel(firstView?: readonly [number, number, number]): void {
    const outline = this.scenery.standOnGround();
    if (outline) this.view.setOutline(outline, firstView);
  }

  /** Gives the canvas the size of the viewport and draws a frame at once, unless frames are held. */
  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.viewport;
    if (width === 0 || height === 0) return;
    this.changes++;
    if (this.frames.isHeld) return;
    this.view.resized(width / height);
    this.frames.resize(width, height);
  }
}
