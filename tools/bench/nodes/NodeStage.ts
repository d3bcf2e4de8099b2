import type { Object3D } from 'three';
import { RenderTarget, WebGPURenderer } from 'three/webgpu';
import { litScene } from '../litScene.js';

/** What a renderer of nodes draws with. */
export type Backend = 'forceWebGL' | 'webgpu';

/** A GPU runs at its full clock only after some frames: the last of so many is timed. */
const FRAMES_PER_QUERY = 8;

/**
 * The counterpart of `Stage` for `WebGPURenderer`. It draws into a render target: presenting WebGPU's canvas ends the graphics process of
 * browsers without a card.
 */
export class NodeStage {
  private readonly target: RenderTarget;
  private readonly lit = litScene();

  private constructor(
    private readonly renderer: WebGPURenderer,
    private readonly hasTimer: boolean,
    size: number,
  ) {
    renderer.setSize(size, size, false);
    this.target = new RenderTarget(size, size);
    renderer.setRenderTarget(this.target);
  }

  /**
   * @param size pixels per side
   * @throws if three.js has taken another backend, or if the page asks for the clock of the GPU (`?clock=gpu`), and the browser has none
   */
  static async open(backend: Backend, size: number): Promise<NodeStage> {
    const hasTimer = new URLSearchParams(location.search).get('clock') === 'gpu';
    const renderer = new WebGPURenderer({
      antialias: false,
      forceWebGL: backend === 'forceWebGL',
      trackTimestamp: hasTimer,
    });
    await renderer.init();
    const { isWebGPUBackend = false } = renderer.backend as { isWebGPUBackend?: boolean };
    if (isWebGPUBackend !== (backend === 'webgpu')) throw new Error(`NodeStage: three.js has not taken ${backend}.`);
    return new NodeStage(renderer, hasTimer, size);
  }

  /** Milliseconds that a frame takes, by the page's clock or by that of the GPU. */
  async timeFrame(object: Object3D): Promise<number> {
    const { scene } = this.lit;
    scene.add(object);
    const time = await (this.hasTimer ? this.timeOnGpu() : this.timeOnPage());
    scene.remove(object);
    return time;
  }

  /** three.js tells the time of the last frame alone. */
  private async timeOnGpu(): Promise<number> {
    const { renderer, lit } = this;
    for (let i = 0; i < FRAMES_PER_QUERY; i++) renderer.render(lit.scene, lit.camera);
    const time = await renderer.resolveTimestampsAsync();
    if (time === undefined) throw new Error('NodeStage: this browser cannot time on the GPU.');
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
