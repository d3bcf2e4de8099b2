import type { WebGLRenderer } from 'three';
import { AdaptiveResolution } from 'three-hatching';
import { whenDrawn } from './graphicsCard.js';

/**
 * The resolution of a sketch per side. The first frame of a model is a sketch, so that slow machines show something early: in lower
 * resolution, without outlines and ground, whose programs are built later.
 */
const SKETCH_SHARE = 0.5;
/** If a placeholder's sketch takes longer than this, it stays until the model itself is ready. */
const LONG_MILLISECONDS = 500;
/** Frames that take no longer than this may follow each other at once. */
const QUICK_MILLISECONDS = 50;
/** If a frame takes longer than this, barely visible changes get no frame of their own. */
const SLOW_MILLISECONDS = 150;

/** What FrameQuality needs from its owner. */
interface FrameQualityHost {
  /** Whether the present model is a placeholder for one that is being baked. */
  isPlaceholder(): boolean;
  /** Requests one frame in full resolution, because nothing moves any more. */
  refine(): void;
  /** Called when the sketch of a model is on the page: the rest is added in the next frame. */
  onSketched(): void;
}

/** Measures frames, and chooses the quality of the next: coarse while something moves on a slow machine, or a sketch. */
export class FrameQuality {
  private isSketching = false;
  private hasBeenSketched = false;
  /** The number of known slow frames that are being drawn. */
  private underway = 0;
  private readonly context: WebGL2RenderingContext;
  private readonly resolution: AdaptiveResolution;
  private readonly listeners: (() => void)[] = [];

  constructor(
    renderer: WebGLRenderer,
    private readonly host: FrameQualityHost,
  ) {
    this.context = renderer.getContext() as WebGL2RenderingContext;
    this.resolution = new AdaptiveResolution(renderer, {
      onRest: () => host.refine(),
      onMeasured: () => this.measured(),
    });
  }

  /** Draws a frame and measures it. @param isMoving whether it shows a movement, in which frames may be coarse */
  measure(draw: () => void, isMoving: boolean): void {
    this.resolution.frame(draw, isMoving);
    const { milliseconds } = this;
    if (milliseconds !== undefined && milliseconds <= QUICK_MILLISECONDS) return;
    this.underway++;
    void whenDrawn(this.context).then(() => this.underway--);
  }

  /**
   * Whether the graphics card is still drawing a slow frame. Another one would be queued, and the page would block as soon as it asks the
   * card for anything, even a canvas of another size.
   */
  get isBusy(): boolean {
    return this.underway > 0;
  }

  /** Whether frames are so slow that barely visible ones are better left out. */
  get isSlow(): boolean {
    return this.milliseconds !== undefined && this.milliseconds >= SLOW_MILLISECONDS;
  }

  /** Calls back when {@link milliseconds} was measured anew, and when a sketch is on the page. */
  onMeasured(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** The duration of a frame, or undefined before one was measured. */
  get milliseconds(): number | undefined {
    return this.resolution.milliseconds;
  }

  /** The share of the full resolution for the next frame. */
  get share(): number {
    return this.isSketching ? SKETCH_SHARE : this.resolution.scale;
  }

  /** Whether frames have a lower resolution, because the machine is too slow for the movement. */
  get isCoarse(): boolean {
    return this.resolution.scale < 1;
  }

  /** Whether frames are sketches, because the model's first frame is still to be drawn or measured. */
  get isSketch(): boolean {
    return this.isSketching;
  }

  /** Whether a picture of the present model is on the page, even a sketch, so that other work no longer delays it. */
  get isOnPage(): boolean {
    return this.hasBeenSketched || (!this.isSketching && this.milliseconds !== undefined);
  }

  /** Forgets the measured duration, because another scene is drawn from now on. @param isSketch whether it begins with a sketch */
  restart(isSketch = this.isSketching): void {
    this.isSketching = isSketch;
    this.hasBeenSketched = false;
    this.resolution.reset();
  }

  /** Draws the whole model from now on, if only its sketch was drawn. */
  finishSketch(): void {
    if (!this.isSketching) return;
    this.restart(false);
    this.hasBeenSketched = true;
    this.host.onSketched();
  }

  /** Call this when a whole frame was drawn without being measured. */
  drawnUnmeasured(): void {
    this.restart(false);
    this.hasBeenSketched = true;
    for (const listener of this.listeners) listener();
  }

  private measured(): void {
    if (this.isSketching) {
      // A whole frame of a slow placeholder would only delay the model itself.
      if (this.host.isPlaceholder() && this.milliseconds! >= LONG_MILLISECONDS) return;
      this.finishSketch();
    }
    for (const listener of this.listeners) listener();
  }
}
