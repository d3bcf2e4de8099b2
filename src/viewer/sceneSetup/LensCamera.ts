import { MathUtils, OrthographicCamera, PerspectiveCamera } from 'three';
import { type CameraLens, halfHeightOf } from '../settings/CameraView.js';

/** The lens of both pages: its vertical field of view in degrees, and what it sees. */
export const LENS = { fieldOfView: 26, near: 0.05, far: 100 } as const;

/** How much a lens without perspective may show, as half the height of its picture. */
const [LEAST_HIGH, MOST_HIGH] = [0.01, 100];

/** A camera for models with a radius of 1, with the lens of the page or one of a file, which may have no perspective. */
export class LensCamera extends PerspectiveCamera {
  /** The planes of a lens without perspective, as an OrthographicCamera has them. */
  left = -1;
  right = 1;
  top = 1;
  bottom = -1;
  private own: CameraLens | undefined = undefined;
  private ownSheet: readonly [number, number] = [1, 1];

  constructor() {
    super(LENS.fieldOfView, 1, LENS.near, LENS.far);
  }

  /** The lens of a file; undefined for that of the page. What is up in the picture goes with it. */
  get lens(): CameraLens | undefined {
    return this.own;
  }

  set lens(lens: CameraLens | undefined) {
    this.own = lens;
    const isFlat = lens?.isOrthographic === true;
    // As renderers and controls tell the two kinds of cameras apart.
    for (const [mark, isMarked] of Object.entries({ isOrthographicCamera: isFlat, isPerspectiveCamera: !isFlat })) {
      if (isMarked) Object.assign(this, { [mark]: true });
      else Reflect.deleteProperty(this, mark);
    }
    this.zoom = 1;
    this.fov = LENS.fieldOfView;
    this.up.set(...(lens?.up ?? [0, 1, 0]));
    this.updateProjectionMatrix();
  }

  /** The sheet in the middle of the picture that the picture of a lens of a file is on, in shares of width and height. */
  get sheet(): readonly [number, number] {
    return this.ownSheet;
  }

  set sheet(sheet: readonly [number, number]) {
    this.ownSheet = sheet;
    if (this.own) this.updateProjectionMatrix();
  }

  /** Shows more or less of what a lens without perspective sees; nothing changes for others. */
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

  /** Takes over the lens of another camera, and the sheet that its picture is on. */
  takeLens({ own, ownSheet, aspect, near, far, zoom }: LensCamera): void {
    this.ownSheet = ownSheet;
    Object.assign(this, { aspect, near, far });
    this.lens = own;
    this.zoom = zoom;
    this.updateProjectionMatrix();
  }
}
