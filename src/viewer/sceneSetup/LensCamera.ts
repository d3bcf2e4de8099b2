import { MathUtils, OrthographicCamera, PerspectiveCamera } from 'three';
import { type CameraLens, halfHeightOf } from '../settings/CameraView.js';

/** The page's and the command's lens: vertical field of view in degrees, and clipping planes. */
export const LENS = { fieldOfView: 26, near: 0.05, far: 100 } as const;

/** The range of half the picture height for an orthographic lens. */
const [LEAST_HIGH, MOST_HIGH] = [0.01, 100];

/** A camera for models of radius 1, with the page's lens or one of a file, which may be orthographic. */
export class LensCamera extends PerspectiveCamera {
  /** The planes of an orthographic lens, named as in OrthographicCamera. */
  left = -1;
  right = 1;
  top = 1;
  bottom = -1;
  private own: CameraLens | undefined = undefined;
  private ownSheet: readonly [number, number] = [1, 1];

  constructor() {
    super(LENS.fieldOfView, 1, LENS.near, LENS.far);
  }

  /** The lens of a file with its up direction; undefined for the page's lens. */
  get lens(): CameraLens | undefined {
    return this.own;
  }

  set lens(lens: CameraLens | undefined) {
    this.own = lens;
    const isFlat = lens?.isOrthographic === true;
    // Renderers and controls tell the two kinds of cameras apart by these flags.
    for (const [mark, isMarked] of Object.entries({ isOrthographicCamera: isFlat, isPerspectiveCamera: !isFlat })) {
      if (isMarked) Object.assign(this, { [mark]: true });
      else Reflect.deleteProperty(this, mark);
    }
    this.zoom = 1;
    this.fov = LENS.fieldOfView;
    this.up.set(...(lens?.up ?? [0, 1, 0]));
    this.updateProjectionMatrix();
  }

  /** The part of the picture, in shares of width and height around its middle, that the picture of a file's lens covers. */
  get sheet(): readonly [number, number] {
    return this.ownSheet;
  }

  set sheet(sheet: readonly [number, number]) {
    this.ownSheet = sheet;
    if (this.own) this.updateProjectionMatrix();
  }

  /** Scales the view of an orthographic lens; perspective lenses stay unchanged. */
  widen(factor: number): void {
    if (!this.own?.isOrthographic) return;
    const high = MathUtils.clamp(this.own.high * factor, LEAST_HIGH, MOST_HIGH);
    this.lens = { ...this.own, high: Math.fround(high) };
  }

  override updateProjectionMatrix(): void {
    const { own, aspect } = this;
    if (!own) {
      super.updateProjectionMatrix();
      return;
    }
    const [wide, high] = this.ownSheet;
    const half = halfHeightOf(own, (aspect * wide) / high) / high;
    if (own.isOrthographic) {
      Object.assign(this, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
      OrthographicCamera.prototype.updateProjectionMatrix.call(this as unknown as OrthographicCamera);
    } else {
      this.fov = 2 * MathUtils.radToDeg(Math.atan(half));
      super.updateProjectionMatrix();
    }
  }

  override copy(source: this, recursive?: boolean): this {
    super.copy(source, recursive);
    this.takeLens(source);
    return this;
  }

  /** Copies the lens of another camera, and the part of the picture that it covers. */
  takeLens({ own, ownSheet, aspect, near, far, zoom }: LensCamera): void {
    this.ownSheet = ownSheet;
    Object.assign(this, { aspect, near, far });
    this.lens = own;
    this.zoom = zoom;
    this.updateProjectionMatrix();
  }
}

/** Default direction from the model to the eye: a three-quarter view, a little from above. */
export const DEFAULT_VIEW = [0.62, 0.36, 1] as const;

/** The page's and the command's camera, for models with a radius of 1. The caller sets its aspect. */
export const createCamera = (): LensCamera => new LensCamera();
