import { RenderTarget, WebGLRenderer, WebGLRenderTarget } from 'three';
import { RenderPipeline, WebGPURenderer } from 'three/webgpu';
import { fromBelow, type Pixels, SIZE } from './picturesOf.js';
import type { Depth, Drawn, Stage } from './SceneCase.js';

/** Draws into a render target: presenting WebGPU's canvas ends the graphics process of browsers without a card. */
export interface Drawer {
  renderer: WebGLRenderer | WebGPURenderer;
  draw(stage: Stage): void;
  read(): Promise<Pixels>;
  dispose(): void;
}

const keeping = (depth: Depth): { logarithmicDepthBuffer: boolean; reversedDepthBuffer: boolean } => ({
  logarithmicDepthBuffer: depth === 'logarithmic',
  reversedDepthBuffer: depth === 'reversed',
});

function drawerInGlsl(depth: Depth): Drawer {
  const renderer = new WebGLRenderer({ antialias: false, ...keeping(depth) });
  renderer.localClippingEnabled = true;
  renderer.setSize(SIZE, SIZE, false);
  const target = new WebGLRenderTarget(SIZE, SIZE);
  return {
    renderer,
    draw({ scene, camera }) {
      renderer.setRenderTarget(target);
      renderer.render(scene, camera);
    },
    async read() {
      const pixels = new Uint8Array(4 * SIZE * SIZE);
      renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, pixels);
      return pixels;
    },
    dispose() {
      target.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}

/** @param size pixels per side */
export async function drawerOfNodes(
  drawn: 'forceWebGL' | 'webgpu',
  size = SIZE,
  depth: Depth = 'plain',
): Promise<Drawer> {
  const renderer = new WebGPURenderer({ antialias: false, forceWebGL: drawn === 'forceWebGL', ...keeping(depth) });
  await renderer.init();
  const { isWebGPUBackend = false } = renderer.backend as { isWebGPUBackend?: boolean };
  if (isWebGPUBackend !== (drawn === 'webgpu')) throw new Error(`drawerOfNodes: three.js has not chosen ${drawn}.`);
  renderer.setSize(size, size, false);
  const target = new RenderTarget(size, size);
  return {
    renderer,
    draw({ scene, camera, through }) {
      renderer.setRenderTarget(target);
      if (!through) {
        renderer.render(scene, camera);
        return;
      }
      const pipeline = new RenderPipeline(renderer, through(scene, camera));
      // Colours in a render target stay linear.
      pipeline.outputColorTransform = false;
      pipeline.render();
    },
    async read() {
      return fromBelow((await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size)) as Pixels, drawn, size);
    },
    dispose() {
      target.dispose();
      renderer.dispose();
    },
  };
}

export const makeDrawer = async (drawn: Drawn, depth: Depth = 'plain'): Promise<Drawer> =>
  drawn === 'glsl' ? drawerInGlsl(depth) : drawerOfNodes(drawn, SIZE, depth);
