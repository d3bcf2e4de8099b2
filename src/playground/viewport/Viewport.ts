import type { BufferGeometry } from 'three';
import type { TonalArtMap } from 'three-hatching';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { WHOLE_SHEET } from '../../viewer/sceneSetup/groundShadow.js';
import type { LensCamera } from '../../viewer/sceneSetup/LensCamera.js';
import type { Look } from '../../viewer/settings/lookOf.js';
import { warmUpModel } from '../loading/placeholderOf.js';
import { ContextLoss } from './ContextLoss.js';
import { FrameQuality } from './FrameQuality.js';
import { Frames } from './Frames.js';
import { Painter } from './Painter.js';
import { Scenery } from './Scenery.js';
import type { ModelChange, ShownModel } from './ShownModel.js';
import { View } from './View.js';

/** The drawing on the page: scenery, camera, frames, and pictures of it. */
export class Viewport {
  readonly scenery: Scenery;
  readonly camera: LensCamera;
  readonly view: View;
  readonly frames: Frames;
  readonly quality: FrameQuality;
  readonly painter: Painter;
  /** The number of changes of view, model, look or viewport size. */
  changes = 0;
  /** A finer geometry of a single-mesh model, used for pictures instead of the frames' geometry. */
  finer: BufferGeometry | undefined;
  private readonly contextLoss: ContextLoss;

  /** Sets up the viewport. A frame is drawn on request, and when the viewport is resized. */
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
      isPlaceholder: () => scenery.shown.isPlaceholder,
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
      (framedPoints, toEye) => scenery.shadowOf(framedPoints, toEye),
    );
    painter.sheetOf = () => this.view.sheet ?? WHOLE_SHEET;
    // Lines where parts meet come some time after the parts.
    scenery.scene.addEventListener('intersections' as 'added', invalidate);
    this.contextLoss = new ContextLoss(painter, scenery, this.frames, this.quality);
    new ResizeObserver(() => this.resize()).observe(viewport);
    this.resize();
  }

  /** The shown model and its replacements. */
  get shown(): ShownModel {
    return this.scenery.shown;
  }

  get model(): HatchedModel | undefined {
    return this.scenery.shown.model;
  }

  /** Applies another look. This is cheap: at most one program is compiled. */
  apply(look: Look): void {
    this.scenery.look = look;
    this.changes++;
    this.show();
    this.painter.outdateShadows();
  }

  /** Draws the model after parts of it were hidden or shown. */
  partsChanged(): void {
    this.changes++;
    this.scenery.outdateCasters();
    this.painter.outdateShadows();
    this.frames.invalidate();
  }

  /** Applies the same look again, because the model's geometries have changed and may need other programs. */
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

  /** Shows the compared technique left of a divider. `share` returns its position in every frame; undefined ends the comparison. */
  compareWith(share: (() => number) | undefined): void {
    this.painter.sides.divider = share;
    this.frames.invalidate();
  }

  /** Makes the next frame redraw the shadow maps, because a light or the model has moved. */
  outdateShadows(): void {
    this.painter.outdateShadows();
  }

  /** Whether there is a model, and a map if the look needs one. */
  get isComplete(): boolean {
    return this.scenery.isComplete;
  }

  /** Whether the graphics context is lost. Changes meanwhile are drawn when it is restored. */
  get isLost(): boolean {
    return this.painter.isLost;
  }

  /** Whether the page shows the last picture from before the context was lost. */
  get showsLastPicture(): boolean {
    return this.contextLoss.showsLastPicture;
  }

  /**
   * Compiles the programs of the first model while it is loaded. Call this when all techniques are loaded. Programs that need a map are not
   * built without one.
   */
  buildAhead(): void {
    const { shown, look } = this.scenery;
    if (shown.drawn || this.isLost || !look || look.needsMap) return;
    shown.setWarmUp(warmUpModel());
    this.show();
  }

  /** Draws a frame once the programs of changed geometries are built. */
  rebuildPrograms(): void {
    const { painter, scenery, quality } = this;
    painter.forgetPrograms();
    if (scenery.look && !quality.isSketch && !this.frames.screen) painter.buildPrograms(scenery.look);
    this.frames.refine();
  }

  /** Applies the look to the scenery. */
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
    // After a placeholder, no sketch is needed: its programs are the model's, and so are its shadows if it was drawn whole.
    this.quality.restart(change === 'another' && !painter.isLost);
    if (!hasShadows) painter.outdateShadows();
    if (change === 'back') frames.forgetPlaceholder();
    this.show();
    this.placeModel(firstView);
    frames.invalidate();
  }

  /** Puts the ground under the model, and frames the model if the previous one was framed. */
  private placeModel(firstView?: readonly [number, number, number]): void {
    const framedPoints = this.scenery.standOnGround();
    if (framedPoints) this.view.setFramedPoints(framedPoints, firstView);
  }

  /** Resizes the canvas to the viewport and draws a frame at once, unless frames are held. */
  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.viewport;
    if (width === 0 || height === 0) return;
    this.changes++;
    if (this.frames.isHeld) return;
    this.view.resized(width / height);
    this.frames.resize(width, height);
  }
}
