import type { Object3D } from 'three';
import { RenderTarget, WebGPURenderer } from 'three/webgpu';
import { GpuClock } from '../GpuClock.js';
import { litScene } from '../litScene.js';

/** The graphics API of a renderer of nodes. */
export type Backend = 'forceWebGL' | 'webgpu';

interface BackendOfThree {
  readonly isWebGPUBackend?: boolean;
  readonly gl?: WebGL2RenderingContext;
}

/**
 * The counterpart of `Stage` for `WebGPURenderer`. It draws into a render target: presenting WebGPU's canvas ends the graphics process of
 * browsers without a card.
 */
export class NodeStage {
  private readonly target: RenderTarget;
  private readonly lit = litScene();

  private constructor(
    private readonly renderer: WebGPURenderer,
    private readonly clock: GpuClock | null,
    size: number,
  ) {
    renderer.setSize(size, size, false);
    this.target = new RenderTarget(size, size);
    renderer.setRenderTarget(this.target);
  }

  /**
   * @param size pixels per side
   * @throws if three.js has taken another backend
   */
  static async open(backend: Backend, size: number): Promise<NodeStage> {
    const renderer = new WebGPURenderer({ antialias: false, forceWebGL: backend === 'forceWebGL' });
    await renderer.init();
    const { isWebGPUBackend = false, gl } = renderer.backend as BackendOfThree;
    if (isWebGPUBackend !== (backend === 'webgpu')) throw new Error(`NodeStage: three.js has not chosen ${backend}.`);
    return new NodeStage(renderer, gl ? GpuClock.of(gl) : null, size);
  }

  /** Milliseconds that a frame takes: with WebGL 2 by the clock of the GPU, if the page's address asks for it, else by that of the page. */
  async timeFrame(object: Object3D): Promise<number> {
    const { renderer, lit, clock } = this;
    const { scene, camera } = lit;
    scene.add(object);
    const time = await (clock ? clock.time(() => renderer.render(scene, camera)) : this.timeOnPage());
    scene.remove(object);
    return time;
  }

  private async timeOnPage(): Promise<number> {
    const { renderer, target, lit } = this;
    const start = performance.now();
    renderer.render(lit.scene, lit.camera);
    // Only reading a pixel waits until the frame is drawn.
    await renderer.readRenderTargetPixelsAsync(target, 0, 0, 1, 1);
    return performance.now() - start;
  }
}
