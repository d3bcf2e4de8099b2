import { type Camera, Matrix4, type Object3D, type WebGLRenderer } from 'three';
import { FrameTimer } from './FrameTimer.js';
import { SizeScaler } from './SizeScaler.js';

/** Options of `MovingResolution`. */
export interface MovingResolutionOptions {
  /** Factor on the pixel ratio while something moves, in (0, 1]. Default 0.5: a quarter of the pixels. */
  share?: number | undefined;
  /** Milliseconds: frames that take longer are slow. Default 55, below which a dragged light does not stutter. */
  slow?: number | undefined;
  /** Milliseconds without a movement after which it is over. Default 350. */
  pause?: number | undefined;
  /** Called when a movement is over that was drawn in a lower resolution. Where frames are drawn on demand: draw one. */
  onRest?: (() => void) | undefined;
  /** Called when it is known how long a frame took, a little after it was drawn. */
  onMeasured?: (() => void) | undefined;
}

/**
 * Keeps movement smooth on slow machines: while the camera, a light or a model moves and frames take long, they are drawn in a
 * lower resolution, and in the full one when the movement is over. Strokes and lines stay as wide as they were.
 *
 * ```ts
 * const resolution = new MovingResolution(renderer, { onRest: requestRender });
 * resolution.render(scene, camera); // in the place of renderer.render(scene, camera)
 * ```
 *
 * Measures frames with a fence, so it works where frames are drawn on demand as well as in a loop. Does nothing in virtual
 * reality, whose resolution the headset chooses.
 *
 * Throws a RangeError for an option out of its range.
 */
export class MovingResolution {
  private readonly share: number;
  private readonly slow: number;
  private readonly pause: number;
  private readonly onRest: (() => void) | undefined;
  private readonly timer: FrameTimer;
  private readonly sizes = new SizeScaler();
  private readonly lastView = new Matrix4();
  private readonly lastProjection = new Matrix4();
  private restTimer: ReturnType<typeof setTimeout> | undefined;
  private isMoving = false;
  private lastMoved = -Infinity;
  private isSlow = false;
  private isLow = false;
  /** The renderer's pixel ratio in full resolution, and what was put in its place; undefined in full resolution. */
  private ratios: { full: number; low: number } | undefined;

  constructor(
    private readonly renderer: WebGLRenderer,
    { share = 0.5, slow = 55, pause = 350, onRest, onMeasured }: MovingResolutionOptions = {},
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

  /** Factor on the full pixel ratio for the next frame: `share` while something moves and frames are slow, else 1. */
  get scale(): number {
    return this.isLow ? this.share : 1;
  }

  /** The median of the latest frame times in milliseconds, or undefined before the first was measured. */
  get milliseconds(): number | undefined {
    return this.timer.milliseconds;
  }

  /**
   * Draws a frame as `renderer.render` does, in the resolution that is right for it.
   *
   * @param isMoving whether something moves in it; if left out, whether the camera does
   */
  render(scene: Object3D, camera: Camera, isMoving = this.hasMoved(camera)): void {
    const { renderer } = this;
    if (renderer.xr.isPresenting) {
      renderer.render(scene, camera);
      return;
    }
    this.frame(() => {
      this.useScale(scene);
      renderer.render(scene, camera);
    }, isMoving);
  }

  /**
   * Draws and measures a frame that is not drawn by `renderer.render` alone, for example by a composer. `draw` sees to the
   * resolution by {@link scale}, and to the widths of strokes, which are measured in pixels.
   *
   * @param isMoving whether something moves in it
   */
  frame(draw: () => void, isMoving = true): void {
    const now = performance.now();
    const goesOn = isMoving && now - this.lastMoved < this.pause;
    this.isMoving = isMoving;
    if (isMoving) this.lastMoved = now;
    if ((this.isSlow && goesOn) || (this.isLow && isMoving)) {
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

  /** Forgets how long frames took. To be called when something else is drawn. */
  reset(): void {
    this.isSlow = false;
    this.timer.reset();
  }

  /** Goes back to the full resolution and stops measuring. */
  dispose(): void {
    clearTimeout(this.restTimer);
    this.isLow = false;
    this.reset();
    this.useFull();
  }

  private useScale(scene: Object3D): void {
    const { renderer, ratios } = this;
    // A ratio that was set from outside is the full one from then on.
    if (!this.isLow || (ratios && ratios.low !== renderer.getPixelRatio())) this.useFull();
    if (!this.isLow || this.ratios) return;
    const full = renderer.getPixelRatio();
    this.ratios = { full, low: full * this.share };
    renderer.setPixelRatio(this.ratios.low);
    this.sizes.scale(scene, this.share);
  }

  private useFull(): void {
    const { renderer, ratios } = this;
    if (!ratios) return;
    if (ratios.low === renderer.getPixelRatio()) renderer.setPixelRatio(ratios.full);
    this.ratios = undefined;
    this.sizes.restore();
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
  if (!isRight) throw new RangeError(`MovingResolution: ${name} is ${value}. Pass ${expected}, or leave it out.`);
}
