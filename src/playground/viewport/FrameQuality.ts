import type { WebGLRenderer } from 'three';
import { AdaptiveResolution } from 'three-hatching';
import { whenDrawn } from './whenDrawn.js';

/**
 * The first frame of a model is a sketch, so that there is something to see early on a slow machine: in a lower resolution, by this
 * factor per side, without outlines and ground, whose programs are built later.
 */
const SKETCH_SHARE = 0.5;
/** A sketch of a stand-in that takes longer stays until the model itself is there. */
const LONG_MILLISECONDS = 500;
/** Frames that take no longer may follow each other at once. */
const QUICK_MILLISECONDS = 50;
/** A frame that takes longer is drawn only for what can be seen clearly. */
const SLOW_MILLISECONDS = 150;

/** What the quality of frames needs to know of its surroundings, and whom it tells. */
interface FrameQualityHost {
  /** Whether the model that is drawn only stands in for one that is being baked. */
  isStandIn(): boolean;
  /** Requests one frame in full resolution, because nothing moves any more. */
  refine(): void;
  /** Called when the sketch of a model is on the page: the rest is added in the next frame. */
  onSketched(): void;
}

/** Measures frames, and tells how finely the next is drawn: coarsely while something moves on a slow machine, or as a sketch. */
export class FrameQuality {
  private isSketching = false;
  private hasBeenSketched = false;
  /** How many frames are being drawn that take long, as far as is known. */
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

  /** Draws a frame and measures it. @param isMoving whether it shows a movement: in one, frames may be drawn coarsely */
  measure(draw: () => void, isMoving: boolean): void {
    this.resolution.frame(draw, isMoving);
    const { milliseconds } = this;
    if (milliseconds !== undefined && milliseconds <= QUICK_MILLISECONDS) return;
    this.underway++;
    void whenDrawn(this.context).then(() => this.underway--);
  }

  /**
   * Whether the graphics card still draws a frame that takes long. Another one would wait in its queue, and the page with it as soon as it
   * asks the card for anything, be it only for a canvas of another size.
   */
  get isBusy(): boolean {
    return this.underway > 0;
  }

  /** Whether frames take so long that those which would show little more are better left out. */
  get isSlow(): boolean {
    return this.milliseconds !== undefined && this.milliseconds >= SLOW_MILLISECONDS;
  }

  /** Calls back when {@link milliseconds} was measured anew, and when a sketch is on the page. */
  onMeasured(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** The time a frame takes, or undefined before one was measured. */
  get milliseconds(): number | undefined {
    return this.resolution.milliseconds;
  }

  /** The share of the full resolution that the next frame is drawn in. */
  get share(): number {
    return this.isSketching ? SKETCH_SHARE : this.resolution.scale;
  }

  /** Whether frames are drawn in a lower resolution, because the machine is too slow for the movement. */
  get isCoarse(): boolean {
    return this.resolution.scale < 1;
  }

  /** Whether frames are sketches, because the first one of the model is still to be drawn or measured. */
  get isSketch(): boolean {
    return this.isSketching;
  }

  /** Whether a picture of what is drawn is on the page, be it a sketch: from then on, other work delays no first picture. */
  get isOnPage(): boolean {
    return this.hasBeenSketched || (!this.isSketching && this.milliseconds !== undefined);
  }

  /** Forgets how long frames took, because something else is drawn from now on. @param isSketch whether it begins with a sketch */
  restart(isSketch = this.isSketching): void {
    this.isSketching = isSketch;
    this.hasBeenSketched = false;
    this.resolution.reset();
  }

  /** Has the whole model drawn from now on, if only its sketch was. */
  finishSketch(): void {
    if (!this.isSketching) return;
    this.restart(false);
    this.hasBeenSketched = true;
    this.host.onSketched();
  }

  /** To be called when a whole frame was drawn that is not measured: its time is unknown. */
  drawnUnmeasured(): void {
    this.restart(false);
    this.hasBeenSketched = true;
    for (const listener of this.listeners) listener();
  }

  private measured(): void {
    if (this.isSketching) {
      // A whole frame of a stand-in that takes long would only delay the model itself.
      if (this.host.isStandIn() && this.milliseconds! >= LONG_MILLISECONDS) return;
      this.finishSketch();
    }
    for (const listener of this.listeners) listener();
  }
}
