import { DirectionalLight, type Object3D, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';

const UP = new Vector3(0, 1, 0);

/** A lit scene on a square canvas that shows one object at a time and tells how long it takes to draw. */
export class Stage {
  private readonly renderer = new WebGLRenderer({ antialias: false });
  private readonly gl = this.renderer.getContext();
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.1, 100);
  private readonly pixel = new Uint8Array(4);

  /**
   * @param size pixels per side
   * @param hasShadows whether the light casts shadows; its map is drawn once, with what is shown first
   */
  constructor(
    private readonly size: number,
    hasShadows = false,
  ) {
    const sun = new DirectionalLight(0xffffff, Math.PI);
    sun.position.set(1, 1, 1);
    if (hasShadows) {
      this.renderer.shadowMap.enabled = true;
      this.renderer.shadowMap.autoUpdate = false;
      this.renderer.shadowMap.needsUpdate = true;
      sun.castShadow = true;
      sun.shadow.mapSize.setScalar(1024);
      Object.assign(sun.shadow.camera, { left: -1.5, right: 1.5, top: 1.5, bottom: -1.5, near: 0.1, far: 5 });
      sun.shadow.bias = -0.002;
      sun.shadow.normalBias = 0.02;
    }
    this.scene.add(sun);
    this.camera.position.set(0, 0.3, 3.2);
    this.camera.lookAt(0, 0, 0);
    this.renderer.setSize(size, size, false);
    document.body.append(this.renderer.domElement);
  }

  /** Moves the camera around what is shown. */
  turnCamera(degrees: number): void {
    this.camera.position.applyAxisAngle(UP, (degrees * Math.PI) / 180);
    this.camera.lookAt(0, 0, 0);
  }

  /** Milliseconds from the first command to the last pixel. */
  timeFrame(object: Object3D): number {
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
