import { type Camera, Matrix4, type Object3D, type WebGLRenderer } from 'three';

const KEPT_DURATIONS = 7;
const POLL_MS = 3;
const GIVE_UP_MS = 10_000;

/**
 * Measures the duration of frames, from the first command to the last pixel, with a fence after the commands. Unlike the time between
 * frames, this works for frames on demand too. It is accurate to a few milliseconds.
 */
class FrameTimer {
  private durations: number[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private fence: WebGLSync | null = null;

  /** @param onMeasured called when a frame was measured */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly onMeasured: () => void,
  ) {}

  /** The median of the latest frame times in milliseconds, or undefined before the first. */
  get milliseconds(): number | undefined {
    const sorted = [...this.durations].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)];
  }

  /** Discards all measurements. Call it when the scene that is drawn has changed. */
  reset(): void {
    this.durations = [];
    this.stop();
  }

  private stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.gl.deleteSync(this.fence);
    this.fence = null;
  }

  /** Draws a frame and measures it, unless the previous frame is still being measured. */
  measure(draw: () => void): void {
    const start = performance.now();
    draw();
    if (this.timer !== undefined) return;
    this.fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!this.fence) return;
    this.gl.flush();
    this.poll(this.fence, start);
  }

  private poll(fence: WebGLSync, start: number): void {
    this.timer = setTimeout(() => {
      const elapsed = performance.now() - start;
      const isDone = this.gl.getSyncParameter(fence, this.gl.SYNC_STATUS) === this.gl.SIGNALED;
      if (!isDone && elapsed < GIVE_UP_MS && !this.gl.isContextLost()) {
        this.poll(fence, start);
        return;
      }
      this.stop();
      if (this.gl.isContextLost()) return;
      // If the frame is still not finished, the time waited so far counts as its duration.
      this.durations.push(elapsed);
      if (this.durations.length > KEPT_DURATIONS) this.durations.shift();
      this.onMeasured();
    }, POLL_MS);
  }
}

/** Options of `AdaptiveResolution`. */
export interface AdaptiveResolutionOptions {
  /** The factor on the pixel ratio while something moves, in (0, 1]. Default 0.5: a quarter of the pixels. */
  share?: number | undefined;
  /** The frame time in milliseconds, 0 or more, above which frames are slow. Default 55: up to it a dragged light is smooth. */
  slow?: number | undefined;
  /** The time in milliseconds, above 0, after which a movement is over. Default 350. */
  pause?: number | undefined;
  /** Called at the end of a movement that was drawn in a lower resolution. If you draw frames on demand, draw one. */
  onRest?: (() => void) | undefined;
  /** Called when a frame was measured, shortly after it was drawn. */
  onMeasured?: (() => void) | undefined;
}

/**
 * Keeps movement smooth on slow machines. While the camera, a light or a model moves and frames are slow, it lowers the renderer's
 * pixel ratio; when the movement is over, it draws in full resolution again. Strokes and outlines keep their widths, which are in CSS
 * pixels.
 *
 * ```ts
 * const resolution = new AdaptiveResolution(renderer, { onRest: requestRender });
 * resolution.render(scene, camera); // instead of renderer.render(scene, camera)
 * ```
 *
 * Frames are measured with a fence, so this works in a loop as well as with frames on demand. It does nothing in virtual reality,
 * where the headset chooses the resolution.
 *
 * The constructor throws a RangeError for an option out of its range.
 */
export class AdaptiveResolution {
  private readonly share: number;
  private readonly slow: number;
  private readonly pause: number;
  private readonly onRest: (() => void) | undefined;
  private readonly timer: FrameTimer;
  private readonly lastView = new Matrix4();
  private readonly lastProjection = new Matrix4();
  private restTimer: ReturnType<typeof setTimeout> | undefined;
  private isMoving = false;
  private lastMoved = -Infinity;
  private isSlow = false;
  private isLow = false;
  /** The pixel ratios of full and of lower resolution; undefined while the renderer draws in full resolution. */
  private ratios: { full: number; low: number } | undefined;

  constructor(
    private readonly renderer: WebGLRenderer,
    { share = 0.5, slow = 55, pause = 350, onRest, onMeasured }: AdaptiveResolutionOptions = {},
  ) {
    check('share', share, share > 0 && share <= 1, 'a number in (0, 1]');
    check('slow', slow, slow >= 0, 'a number of milliseconds, 0 or more');
    check('pause', pause, pause > 0 && pause < Infinity, 'a positive number of milliseconds');
    this.share = share;
    this.slow = slow;
    this.pause = pause;
    this.onRest = onRest;
    this.timer = new FrameTimer(renderer.getContext() as WebGL2RenderingContext, () => {
      if (!this.isLow) this.isSlow = this.timer.milliseconds! > this.slow;
      // A slow frame does not end a movement.
      if (this.isMoving) this.lastMoved = Math.max(this.lastMoved, performance.now());
      onMeasured?.();
    });
  }

  /** The factor for the pixel ratio of the next frame: `share` while something moves and frames are slow, otherwise 1. */
  get scale(): number {
    return this.isLow ? this.share : 1;
  }

  /** The median of the latest frame times in milliseconds, or undefined before the first was measured. */
  get milliseconds(): number | undefined {
    return this.timer.milliseconds;
  }

  /**
   * Draws a frame as `renderer.render` does, in the appropriate resolution.
   *
   * @param isMoving whether something moves in this frame. Default: whether the camera has moved.
   */
  render(scene: Object3D, camera: Camera, isMoving = this.hasMoved(camera)): void {
    const { renderer } = this;
    if (renderer.xr.isPresenting) {
      renderer.render(scene, camera);
      return;
    }
    this.frame(() => {
      this.useScale();
      renderer.render(scene, camera);
    }, isMoving);
  }

  /**
   * Draws and measures a frame that is not drawn by `renderer.render` alone, but for example by a composer. `draw` must multiply the
   * pixel ratio of renderer and composer by {@link scale} itself.
   *
   * @param isMoving whether something moves in this frame
   */
  frame(draw: () => void, isMoving = true): void {
    const now = performance.now();
    const continues = isMoving && now - this.lastMoved < this.pause;
    this.isMoving = isMoving;
    if (isMoving) this.lastMoved = now;
    if ((this.isSlow && continues) || (this.isLow && isMoving)) {
      this.isLow = true;
      clearTimeout(this.restTimer);
      this.restTimer = setTimeout(() => {
        this.isLow = false;
        this.lastMoved = -Infinity;
        this.onRest?.();
      }, this.pause);
    }
    this.timer.measure(draw);
  }

  /** Forgets all measurements. Call it when the scene that is drawn has changed. */
  reset(): void {
    this.isSlow = false;
    this.timer.reset();
  }

  /** Returns to full resolution and stops measuring. */
  dispose(): void {
    clearTimeout(this.restTimer);
    this.isLow = false;
    this.reset();
    this.useFull();
  }

  private useScale(): void {
    const { renderer, ratios } = this;
    // A pixel ratio that other code has set becomes the new full one.
    if (!this.isLow || (ratios && ratios.low !== renderer.getPixelRatio())) this.useFull();
    if (!this.isLow || this.ratios) return;
    const full = renderer.getPixelRatio();
    this.ratios = { full, low: full * this.share };
    renderer.setPixelRatio(this.ratios.low);
  }

  private useFull(): void {
    const { renderer, ratios } = this;
    if (!ratios) return;
    if (ratios.low === renderer.getPixelRatio()) renderer.setPixelRatio(ratios.full);
    this.ratios = undefined;
  }

  private hasMoved(camera: Camera): boolean {
    camera.updateWorldMatrix(true, false);
    const hasMoved = !this.lastView.equals(camera.matrixWorld) || !this.lastProjection.equals(camera.projectionMatrix);
    this.lastView.copy(camera.matrixWorld);
    this.lastProjection.copy(camera.projectionMatrix);
    return hasMoved;
  }
}

function check(name: string, value: number, isRight: boolean, expected: string): void {
  if (!isRight) throw new RangeError(`AdaptiveResolution: ${name} is ${value}. Pass ${expected}, or leave it out.`);
}
