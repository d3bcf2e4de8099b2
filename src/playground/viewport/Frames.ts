import { CrossFade } from './CrossFade.js';
import type { FrameQuality } from './FrameQuality.js';
import type { Painter } from './Painter.js';
import type { Scenery } from './Scenery.js';

const MAX_PIXEL_RATIO = 2;
/** On very large screens the pixel ratio is lowered to stay below this. */
const MAX_PIXELS = 8_000_000;

/** Device pixels per CSS pixel while nothing moves. `width` and `height` are the size of the viewport in CSS pixels. */
const fullPixelRatio = (width: number, height: number): number =>
  Math.min(devicePixelRatio, MAX_PIXEL_RATIO, Math.sqrt(MAX_PIXELS / Math.max(1, width * height)));

/** Schedules frames on demand, at most one per refresh of the screen. An idle page draws no frames. */
export class FrameScheduler {
  /** Number of frames drawn so far. */
  frames = 0;
  private request = 0;

  /**
   * @param draw draws a frame
   * @param mustWait whether a requested frame has to be postponed to the next refresh
   */
  constructor(
    private readonly draw: () => void,
    private readonly mustWait: () => boolean = () => false,
  ) {}

  /** Requests one frame. Further requests before it is drawn have no effect. */
  invalidate(): void {
    this.request ||= requestAnimationFrame(this.onFrame);
  }

  /** Whether a requested frame is not drawn yet. */
  get isWaiting(): boolean {
    return this.request !== 0;
  }

  private readonly onFrame = (): void => {
    if (this.mustWait()) {
      this.request = requestAnimationFrame(this.onFrame);
      return;
    }
    this.request = 0;
    this.frames++;
    this.draw();
  };
}

/** Draws frames into the viewport: on demand, and continuously while the model is animated. */
export class Frames {
  /** Whether frames are suspended while a picture is drawn in tiles: nothing may move, and the canvas holds the latest tile. */
  isHeld = false;
  /** The number of tasks in progress that will change what is drawn. */
  private exchanging = 0;
  /** Whether such a change has happened since the last frame; the stored picture then fades into the next one. */
  private isExchanged = false;
  /** Whether the next frame shows a movement, instead of only adding detail. */
  private isMoving = false;
  private lastFrame = 0;
  /** The screen that draws frames in place of the painter. */
  private wanted: Screen | undefined;
  /** The screen that shows the last frame; undefined for the painter. */
  private shownOn: Screen | undefined;
  private readonly scheduler: FrameScheduler;
  private readonly crossFade: CrossFade;
  private readonly listeners: (() => void)[] = [];
  private readonly waiting: (() => void)[] = [];

  constructor(
    private readonly painter: Painter,
    private readonly scenery: Scenery,
    private readonly quality: FrameQuality,
    private readonly viewport: HTMLElement,
  ) {
    this.crossFade = new CrossFade(painter.canvas, () => this.canvas);
    // Deferred, because the page waits for other resources before the first model.
    setTimeout(() => this.crossFade.prepare());
    this.scheduler = new FrameScheduler(
      () => {
        // While programs compile, the last frame stays on the page.
        if (!this.isBuilding) this.draw();
      },
      () => this.mustWait(),
    );
  }

  /** Requests one frame. */
  invalidate(): void {
    this.isMoving = true;
    this.scheduler.invalidate();
  }

  /** Requests one frame that adds detail without movement, in full resolution however long frames take. */
  refine(): void {
    this.scheduler.invalidate();
  }

  /** The canvas that shows the last frame. */
  get canvas(): HTMLCanvasElement {
    return (this.shownOn ?? this.painter).canvas;
  }

  /** The screen for the next frame; undefined for the painter. */
  get screen(): Screen | undefined {
    return this.wanted?.canDraw ? this.wanted : undefined;
  }

  /** Draws frames on a screen as far as it can, or with the painter alone. The previous screen is disposed of once it is hidden. */
  drawOn(screen: Screen | undefined): void {
    const before = this.wanted;
    this.wanted = screen;
    if (before !== this.shownOn) before?.dispose();
    this.refine();
  }

  /** Calls back after each frame, in its task. */
  onFrame(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Calls back at each refresh in which a frame is postponed, so that overlays can move on. The lights are placed by then. */
  onWait(listener: () => void): void {
    this.waiting.push(listener);
  }

  /** The number of requested frames that were drawn. */
  get count(): number {
    return this.scheduler.frames;
  }

  /** True while programs compile. The page shows an earlier frame meanwhile. */
  get isBuilding(): boolean {
    return this.painter.isBuilding || this.screen?.isBuilding === true;
  }

  /** Whether a requested frame is not drawn yet, or the model is drawn as a sketch only. */
  get isWaiting(): boolean {
    const { painter, quality } = this;
    return this.scheduler.isWaiting || this.isBuilding || (quality.isSketch && !painter.isLost);
  }

  /**
   * Whether the page's picture is final: no frame is pending or being drawn, no full resolution will follow a coarse frame, and nothing
   * fades.
   */
  get isSettled(): boolean {
    const { quality, crossFade } = this;
    return !this.isWaiting && !quality.isBusy && !quality.isCoarse && !crossFade.isFading;
  }

  /** Discards the copied picture of a placeholder, which would have faded into the model's. */
  forgetPlaceholder(): void {
    this.crossFade.forget();
  }

  /**
   * Copies each picture from now on, because {@link fadeIntoNext} will be called: copying later would require drawing it again, which takes
   * a second on a slow machine.
   */
  keepPictures(): void {
    this.exchanging++;
  }

  /** Ends {@link keepPictures}; call it as often. */
  leavePictures(): void {
    this.exchanging--;
    if (this.exchanging === 0 && !this.isExchanged && !this.scenery.shown.isPlaceholder) this.crossFade.forgetKept();
  }

  /** Fades the present picture into the next one, unless another is fading. Call this before the scene changes. */
  fadeIntoNext(): void {
    this.isExchanged = true;
    if (!this.crossFade.isBusy && this.redraw()) this.crossFade.keep();
  }

  /** Resizes the canvas to the viewport and draws at once, because resizing clears it. */
  resize(width: number, height: number): void {
    const { painter, quality } = this;
    if (!this.screen) {
      painter.pixelRatio = fullPixelRatio(width, height) * quality.share;
      painter.renderer.setSize(width, height, false);
    }
    quality.restart();
    this.draw();
  }

  /** Draws a frame at once. */
  draw(): void {
    const { scenery, quality, crossFade, screen } = this;
    const size = this.drawableSize;
    if (!size || screen?.prepare() === false) return;
    if (screen) this.drawScreen(screen, size);
    else {
      if (this.shownOn) this.painter.renderer.setSize(size.width, size.height, false);
      quality.measure(() => this.drawFrame(size), this.isMoving);
      this.show(undefined);
    }
    this.isMoving = false;
    // A placeholder fades into what replaces it, even another placeholder.
    if ((scenery.shown.isPlaceholder || this.exchanging > 0) && !this.isExchanged) crossFade.keep();
    else crossFade.start();
    this.isExchanged = false;
    if (!quality.isSketch) scenery.shown.disposePrevious();
    for (const listener of this.listeners) listener();
    if (scenery.shown.model?.motion?.isPlaying) this.invalidate();
  }

  /**
   * Draws the present picture again, so that it can be copied in the same task. This frame is not measured.
   *
   * @returns whether there is a picture
   */
  redraw(): boolean {
    const { screen } = this;
    const size = this.drawableSize;
    if (!size || screen !== this.shownOn || screen?.prepare() === false) return false;
    if (screen) screen.draw({ ...size, ratio: fullPixelRatio(size.width, size.height) });
    else this.painter.drawTile({ viewWidth: size.width, x: 0, ...size });
    return true;
  }

  /** Whether a frame has to wait for an earlier slow one. */
  private mustWait(): boolean {
    const { quality, painter } = this;
    if (this.isHeld || !quality.isBusy) return false;
    painter.placeLights(quality.isCoarse ? 'coarse' : 'usual');
    for (const listener of this.waiting) listener();
    return true;
  }

  /** The viewport's size in CSS pixels; undefined if no frame can be drawn into it. */
  private get drawableSize(): { width: number; height: number } | undefined {
    const { clientWidth: width, clientHeight: height } = this.viewport;
    return this.isHeld || this.painter.isLost || width === 0 || height === 0 ? undefined : { width, height };
  }

  private drawFrame({ width, height }: { width: number; height: number }): void {
    const { painter, scenery, quality } = this;
    this.advanceMotion();
    painter.placeLights(quality.isCoarse ? 'coarse' : 'usual');
    // Without a model, the ground is left out: it is no drawing by itself, and its programs would be built before the model's.
    if (quality.isSketch || !scenery.shown.model) scenery.showSketch();
    painter.pixelRatio = fullPixelRatio(width, height) * quality.share;
    painter.drawTile({ viewWidth: width, x: 0, width, height });
  }

  private drawScreen(screen: Screen, { width, height }: { width: number; height: number }): void {
    const { painter, quality } = this;
    quality.finishSketch();
    this.advanceMotion();
    painter.placeLights('usual');
    painter.release();
    screen.draw({ width, height, ratio: fullPixelRatio(width, height) });
    this.show(screen);
    quality.drawnUnmeasured();
  }

  /** Shows the canvas of a screen, or the painter's. */
  private show(screen: Screen | undefined): void {
    const before = this.shownOn;
    if (before === screen) return;
    this.shownOn = screen;
    if (screen) screen.canvas.hidden = false;
    if (!before) return;
    before.canvas.hidden = true;
    if (before !== this.wanted) before.dispose();
  }

  /** Advances the model's animation by the time since the last frame. */
  private advanceMotion(): void {
    const now = performance.now();
    this.scenery.shown.model?.motion?.advance((now - this.lastFrame) / 1000);
    this.lastFrame = now;
  }
}

/** Size of a frame in CSS pixels, and device pixels per CSS pixel. */
export interface FrameSize {
  width: number;
  height: number;
  ratio: number;
}

/** Draws frames with another renderer, on its own canvas over the painter's. */
export interface Screen {
  readonly canvas: HTMLCanvasElement;
  /** Whether its renderer supports the present look. If not, the painter draws. */
  readonly canDraw: boolean;
  /** True while programs compile, also for the first frame. A frame is requested when they are ready. */
  readonly isBuilding: boolean;
  /** Whether a frame can be drawn now. If not, starts building what it needs; a frame is requested afterwards. */
  prepare(): boolean;
  draw(size: FrameSize): void;
  dispose(): void;
}
