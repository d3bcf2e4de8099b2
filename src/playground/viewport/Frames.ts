import { CrossFade } from './CrossFade.js';
import type { FrameQuality } from './FrameQuality.js';
import type { Painter } from './Painter.js';
import type { Scenery } from './Scenery.js';
import type { Screen } from './Screen.js';

const MAX_PIXEL_RATIO = 2;
/** On very large screens the pixel ratio is lowered to stay below this. */
const MAX_PIXELS = 8_000_000;

/** How many pixels are drawn per CSS pixel of a viewport while nothing moves. `width` and `height` are its size in CSS pixels. */
const fullPixelRatio = (width: number, height: number): number =>
  Math.min(devicePixelRatio, MAX_PIXEL_RATIO, Math.sqrt(MAX_PIXELS / Math.max(1, width * height)));

/** Calls for frames on demand, at most once per refresh of the screen. An idle page draws no frames. */
export class FrameScheduler {
  /** Number of frames drawn so far. */
  frames = 0;
  private request = 0;

  /**
   * @param draw draws a frame
   * @param mustWait whether a frame that was requested has to wait: it is asked for anew with the next refresh
   */
  constructor(
    private readonly draw: () => void,
    private readonly mustWait: () => boolean = () => false,
  ) {}

  /** Requests one frame. Further requests before it is drawn have no effect. */
  invalidate(): void {
    this.request ||= requestAnimationFrame(this.onFrame);
  }

  /** Whether a frame was requested and is not drawn yet. */
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

/** Draws frames into the viewport: on demand, and one after the other while the model moves by itself. */
export class Frames {
  /** Whether no frames are drawn, because a picture is drawn in tiles: nothing may move, and the canvas holds the latest tile. */
  isHeld = false;
  /** How many works go on, each of which will exchange something that is drawn. */
  private exchanging = 0;
  /** Whether what is drawn has been exchanged since the last frame, into which the kept picture fades. */
  private isExchanged = false;
  /** Whether the next frame shows a movement, and does not only add to what is drawn. */
  private isMoving = false;
  private lastFrame = 0;
  /** What frames are drawn on where the painter does not draw them. */
  private wanted: Screen | undefined;
  /** That which shows the last frame; undefined if the painter has drawn it. */
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
    // Before the first model, the page waits for others.
    setTimeout(() => this.crossFade.prepare());
    this.scheduler = new FrameScheduler(
      () => {
        // Until the programs are built, the last frame stays on the page.
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

  /** Requests one frame that adds to what is drawn where nothing moves. It is drawn in full resolution however long frames take. */
  refine(): void {
    this.scheduler.invalidate();
  }

  /** The canvas that shows the last frame. */
  get canvas(): HTMLCanvasElement {
    return (this.shownOn ?? this.painter).canvas;
  }

  /** Where the next frame is drawn; undefined if the painter draws it. */
  get screen(): Screen | undefined {
    return this.wanted?.canDraw ? this.wanted : undefined;
  }

  /** Has frames drawn on a screen, as far as it can, or by the painter alone. The screen before is disposed of when it is not seen any more. */
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

  /** Calls back with each refresh of the screen in which a frame has to wait: what lies over the drawing need not. The lights are placed by then. */
  onWait(listener: () => void): void {
    this.waiting.push(listener);
  }

  /** The number of frames that were requested and drawn. */
  get count(): number {
    return this.scheduler.frames;
  }

  /** Whether what frames are drawn with is being built. Meanwhile the page shows an earlier frame. */
  get isBuilding(): boolean {
    return this.painter.isBuilding || this.screen?.isBuilding === true;
  }

  /** Whether a frame was requested and is not drawn yet, or a model was drawn as a sketch only. */
  get isWaiting(): boolean {
    const { painter, quality } = this;
    return this.scheduler.isWaiting || this.isBuilding || (quality.isSketch && !painter.isLost);
  }

  /**
   * Whether what the page shows stays as it is: no frame is awaited or being drawn, none in full resolution will follow a coarse one, and
   * no picture fades.
   */
  get isSettled(): boolean {
    const { quality, crossFade } = this;
    return !this.isWaiting && !quality.isBusy && !quality.isCoarse && !crossFade.isFading;
  }

  /** Discards the picture of a stand-in, which would have faded into that of the model. */
  forgetStandIn(): void {
    this.crossFade.forget();
  }

  /**
   * Has each picture copied from now on, because {@link fadeIntoNext} will be called: a picture that is to be copied later has to be
   * drawn a second time, for which a slow machine takes a second.
   */
  keepPictures(): void {
    this.exchanging++;
  }

  /** Ends what {@link keepPictures} began: to be called as often. */
  leavePictures(): void {
    this.exchanging--;
    if (this.exchanging === 0 && !this.isExchanged && !this.scenery.shown.isStandIn) this.crossFade.forgetKept();
  }

  /** Lets the picture that is shown fade into the next one, unless another fades at the moment. To be called before what is drawn changes. */
  fadeIntoNext(): void {
    this.isExchanged = true;
    if (!this.crossFade.isBusy && this.redraw()) this.crossFade.keep();
  }

  /** Gives the canvas the size of the viewport. It is drawn at once and not in the next frame, because resizing clears it. */
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
    // A stand-in fades into what takes its place, be it another stand-in.
    if ((scenery.shown.isStandIn || this.exchanging > 0) && !this.isExchanged) crossFade.keep();
    else crossFade.start();
    this.isExchanged = false;
    if (!quality.isSketch) scenery.shown.disposePrevious();
    for (const listener of this.listeners) listener();
    if (scenery.shown.model?.motion?.isPlaying) this.invalidate();
  }

  /**
   * Draws the picture that is shown once more, so that it can be copied in the same task. This frame is not measured.
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

  /** Whether a frame has to wait for an earlier one that takes long. */
  private mustWait(): boolean {
    const { quality, painter } = this;
    if (this.isHeld || !quality.isBusy) return false;
    painter.placeLights(quality.isCoarse ? 'coarse' : 'usual');
    for (const listener of this.waiting) listener();
    return true;
  }

  /** The viewport's size in CSS pixels; undefined where no frame can be drawn into it. */
  private get drawableSize(): { width: number; height: number } | undefined {
    const { clientWidth: width, clientHeight: height } = this.viewport;
    return this.isHeld || this.painter.isLost || width === 0 || height === 0 ? undefined : { width, height };
  }

  private drawFrame({ width, height }: { width: number; height: number }): void {
    const { painter, scenery, quality } = this;
    this.advanceMotion();
    painter.placeLights(quality.isCoarse ? 'coarse' : 'usual');
    // A ground alone would be no drawing, and its programs would be built before those of the model.
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

  /** Has the page show what a screen has drawn, or the painter. */
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
