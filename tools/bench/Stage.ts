import { type Object3D, type PerspectiveCamera, type Scene, Vector3, WebGLRenderer } from 'three';
import { GpuClock } from './GpuClock.js';
import { castShadow, litScene } from './litScene.js';

const UP = new Vector3(0, 1, 0);

/**
 * A lit scene on a square canvas that shows one object at a time and tells how long it takes to draw.
 *
 * Where the page's address ends in `?clock=gpu`, the GPU itself times the frames (`EXT_disjoint_timer_query_webgl2`): the processor
 * takes longer to send them and to wait for them than the GPU takes to draw them. A software rasteriser is timed by the page's clock.
 */
export class Stage {
  private readonly renderer = new WebGLRenderer({ antialias: false });
  private readonly gl = this.renderer.getContext() as WebGL2RenderingContext;
  private readonly scene: Scene;
  private readonly camera: PerspectiveCamera;
  private readonly pixel = new Uint8Array(4);
  private readonly clock: GpuClock | null;

  /**
   * @param size pixels per side
   * @param hasShadows whether the light casts shadows; its map is drawn once, with what is shown first
   */
  constructor(
    private readonly size: number,
    hasShadows = false,
  ) {
    const { scene, camera, sun } = litScene();
    this.scene = scene;
    this.camera = camera;
    if (hasShadows) {
      castShadow(this.renderer, sun);
      this.renderer.shadowMap.autoUpdate = false;
      this.renderer.shadowMap.needsUpdate = true;
    }
    this.renderer.setSize(size, size, false);
    document.body.append(this.renderer.domElement);
    this.clock = GpuClock.of(this.gl);
  }

  /** Moves the camera around what is shown. */
  turnCamera(degrees: number): void {
    this.camera.position.applyAxisAngle(UP, (degrees * Math.PI) / 180);
    this.camera.lookAt(0, 0, 0);
  }

  /** Moves the camera away from what is shown: its distance grows by a factor. */
  moveAway(factor: number): void {
    this.camera.position.multiplyScalar(factor);
  }

  /** Draws a frame. @returns its pixels as RGBA, the lowest row first */
  readFrame(object: Object3D): Uint8Array {
    const { renderer, gl, scene, camera, size } = this;
    const pixels = new Uint8Array(4 * size * size);
    scene.add(object);
    renderer.render(scene, camera);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    scene.remove(object);
    return pixels;
  }

  /** Milliseconds that a frame takes, by the page's clock. */
  async timeFrame(object: Object3D): Promise<number> {
    if (!this.clock) return this.drawFrame(object);
    const { renderer, scene, camera } = this;
    scene.add(object);
    const time = await this.clock.time(() => renderer.render(scene, camera));
    scene.remove(object);
    return time;
  }

  /** Milliseconds of the page's clock from the first command to the last pixel. */
  drawFrame(object: Object3D): number {
    const { renderer, gl, scene, camera, pixel, size } = this;
    scene.add(object);
    const start = performance.now();
    renderer.render(scene, camera);
    // Only reading a pixel waits until the frame is drawn; gl.finish() returns early.
    gl.readPixels(size / 2, size / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    const time = performance.now() - start;
    scene.remove(object);
    return time;
  }
}
