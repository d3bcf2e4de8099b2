import { Box3, type PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { CameraView } from '../settings/CameraView.js';
import { DEFAULT_VIEW } from './createCamera.js';
import { framingDistance } from './framing.js';
import { OrbitKeys } from './OrbitKeys.js';

/** From what it turns around, in radii of the model: near enough to look into a room. */
const MIN_DISTANCE = 0.15;

/** Controls the camera: orbited by the user, or placed so that the whole model is in the picture. */
export class View {
  readonly controls: OrbitControls;
  private readonly keys: OrbitKeys;
  /** Whether the camera is where {@link frame} put it. If so, it is placed again when the viewport changes its size. */
  private framed = true;
  private isFraming = false;
  private readonly first = new Vector3(...DEFAULT_VIEW);
  private readonly bounds = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));

  /** @param onChange called when a frame must be drawn */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly camera: PerspectiveCamera,
    private readonly onChange: () => void,
  ) {
    this.controls = new OrbitControls(camera, canvas);
    this.controls.minDistance = MIN_DISTANCE;
    this.controls.zoomToCursor = true;
    this.controls.maxDistance = 30;
    this.controls.addEventListener('change', () => {
      if (!this.isFraming) this.framed = false;
      onChange();
    });
    this.keys = new OrbitKeys(canvas, camera, this.controls, this.frame);
    canvas.addEventListener('dblclick', this.frame);
  }

  get isFramed(): boolean {
    return this.framed;
  }

  /** Places the camera so that the whole model is in the picture. */
  readonly frame = (): void => {
    this.isFraming = true;
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(this.first).setLength(framingDistance(this.bounds, this.first, this.camera));
    this.controls.update();
    this.isFraming = false;
    this.framed = true;
    this.onChange();
  };

  /**
   * Sets the bounds of a new model, or of one that was turned.
   *
   * @param first direction to the eye when the model is framed; undefined keeps the current one
   */
  setBounds(bounds: Box3, first?: readonly [number, number, number]): void {
    this.bounds.copy(bounds);
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
    this.controls.update();
    this.onChange();
  }

  dispose(): void {
    this.keys.dispose();
    this.controls.dispose();
  }
}
