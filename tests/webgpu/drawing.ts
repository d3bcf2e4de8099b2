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

const ofCanvases = new Map<'glsl' | 'forceWebGL', WebGLRenderer | WebGPURenderer>();

/** The renderer of a transparent canvas. */
async function rendererOfCanvas(drawn: 'glsl' | 'forceWebGL'): Promise<WebGLRenderer | WebGPURenderer> {
  const known = ofCanvases.get(drawn);
  if (known) return known;
  const parameters = { antialias: false, alpha: true };
  const made =
    drawn === 'glsl' ? new WebGLRenderer(parameters) : new WebGPURenderer({ ...parameters, forceWebGL: true });
  if (made instanceof WebGPURenderer) await made.init();
  made.setSize(SIZE, SIZE, false);
  ofCanvases.set(drawn, made);
  return made;
}

/**
 * Draws on a canvas, as a white page shows it. There `WebGLRenderer` blends sRGB, and `WebGPURenderer` linear light that it encodes at the
 * end. Nodes are drawn with the WebGL 2 backend.
 */
export async function drawOnCanvas({ scene, camera }: Stage, drawn: 'glsl' | 'forceWebGL'): Promise<Pixels> {
  const renderer = await rendererOfCanvas(drawn);
  renderer.render(scene, camera);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const read = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  const pixels = new Uint8Array(4 * SIZE * SIZE);
  gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, read);
  return pixels.map((value, i) => value + 255 - pixels[i | 3]);
}

export const makeDrawer = async (drawn: Drawn, depth: Depth = 'plain'): Promise<Drawer> =>
  drawn === 'glsl' ? drawerInGlsl(depth) : drawerOfNodes(drawn, SIZE, depth);
