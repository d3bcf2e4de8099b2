import { type PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { CameraView } from '../settings/CameraView.js';
import { DEFAULT_VIEW } from './createCamera.js';
import { type Framing, fitCamera } from './framing.js';
import { OrbitKeys } from './OrbitKeys.js';

/** From what it turns around, in radii of the model: near enough to look into a room. */
const MIN_DISTANCE = 0.15;
/** Share of the viewport that a model fills, of its width or its height: about two thirds of the sheet with its caption. */
const FILL = 0.76;
/** Before there is a model. */
const NO_OUTLINE = [-1, -1, -1, 1, 1, 1];

/** Controls the camera: orbited by the user, or placed so that the whole model is in the picture. */
export class View {
  readonly controls: OrbitControls;
  /** Called when the user has moved the camera. */
  onMoved: () => void = () => {};
  private readonly keys: OrbitKeys;
  /** Whether the camera is where {@link frame} put it. If so, it is placed again when the viewport changes its size. */
  private framed = true;
  private isPlacing = false;
  private readonly first = new Vector3(...DEFAULT_VIEW);
  private outline: ArrayLike<number> = NO_OUTLINE;
  private shadow: ArrayLike<number> | undefined;

  /**
   * @param onChange called when a frame must be drawn
   * @param shadowOf xyz of points of the shadow that an outline casts by now; undefined without one
   */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly camera: PerspectiveCamera,
    private readonly onChange: () => void,
    private readonly shadowOf: (outline: ArrayLike<number>) => ArrayLike<number> | undefined,
  ) {
    this.controls = new OrbitControls(camera, canvas);
    this.controls.minDistance = MIN_DISTANCE;
    this.controls.zoomToCursor = true;
    this.controls.maxDistance = 30;
    this.controls.addEventListener('change', () => {
      if (!this.isPlacing) {
        this.framed = false;
        this.onMoved();
      }
      onChange();
    });
    this.keys = new OrbitKeys(canvas, camera, this.controls, this.frameForUser);
    canvas.addEventListener('dblclick', this.frameForUser);
  }

  /** As {@link frame}, because the user has asked for it. */
  readonly frameForUser = (): void => {
    this.shadow = this.shadowOf(this.outline);
    this.frame();
    this.onMoved();
  };

  /** Zooms with the wheel only while an element has the focus, so that a page around it can be scrolled. */
  zoomsWhenFocused(element: HTMLElement): void {
    this.controls.enableZoom = false;
    element.addEventListener('focus', () => {
      this.controls.enableZoom = true;
    });
    element.addEventListener('blur', () => {
      this.controls.enableZoom = false;
    });
  }

  get isFramed(): boolean {
    return this.framed;
  }

  /** Places the camera so that the whole model is in the picture, and its shadow if that is not long. */
  readonly frame = (): void => {
    this.isPlacing = true;
    const { outline, first, ...framing } = this.framing;
    this.controls.target.copy(fitCamera(this.camera, outline, first, framing));
    this.controls.update();
    this.isPlacing = false;
    this.framed = true;
    this.onChange();
  };

  /** What the model is framed by, as {@link fitCamera} takes it. */
  get framing(): Framing & { outline: ArrayLike<number>; first: Vector3 } {
    return { outline: this.outline, first: this.first, fill: FILL, shadow: this.shadow };
  }

  /**
   * Sets the outline of a new model, or of one that was turned.
   *
   * @param outline xyz of points of it, enough to tell where it ends
   * @param first direction to the eye when the model is framed; undefined keeps the current one
   */
  setOutline(outline: ArrayLike<number>, first?: readonly [number, number, number]): void {
    this.outline = outline;
    this.shadow = this.shadowOf(outline);
    if (first) this.first.set(...first);
    if (this.framed) this.frame();
  }

  /** To be called when the viewport has changed its size. */
  resized(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    if (this.framed) this.frame();
  }

  get place(): CameraView {
    return { position: this.camera.position.toArray(), target: this.controls.target.toArray() };
  }

  set place({ position, target }: CameraView) {
    this.camera.position.fromArray(position);
    this.controls.target.fromArray(target);
    this.isPlacing = true;
    this.controls.update();
    this.isPlacing = false;
    this.framed = false;
    this.onChange();
  }

  dispose(): void {
    this.keys.dispose();
    this.controls.dispose();
  }
}
