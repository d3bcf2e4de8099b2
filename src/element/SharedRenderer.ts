import { WebGLRenderer } from 'three';
import type { Drawing } from './Drawing.js';

/**
 * Draws all elements of a page in one WebGL context, because browsers allow only about sixteen, and copies each frame to the canvas of
 * its element. It exists as long as it has users.
 */
export class SharedRenderer {
  private static shared: SharedRenderer | undefined;
  private readonly users = new Set<() => void>();
  private readonly buffer: HTMLCanvasElement;
  private readonly context: WebGL2RenderingContext;
  readonly renderer: WebGLRenderer;

  /**
   * Returns the page's renderer, and registers a user.
   *
   * @param onRestored called when the context is restored after it was lost
   * @throws Error if the browser has no WebGL 2
   */
  static acquire(onRestored: () => void): SharedRenderer {
    SharedRenderer.shared ??= new SharedRenderer();
    SharedRenderer.shared.users.add(onRestored);
    return SharedRenderer.shared;
  }

  private constructor() {
    this.buffer = document.createElement('canvas');
    const context = this.buffer.getContext('webgl2', { antialias: true, stencil: false });
    if (!context) throw new Error('Drawings need WebGL 2, which this browser does not offer here.');
    this.context = context;
    this.renderer = new WebGLRenderer({ canvas: this.buffer, context });
    this.renderer.shadowMap.enabled = true;
    this.renderer.setScissorTest(true);
    this.buffer.addEventListener('webglcontextrestored', this.onRestored);
  }

  /** Must be called once for each `acquire`, with the same function. The context is freed with its last user. */
  release(onRestored: () => void): void {
    this.users.delete(onRestored);
    if (this.users.size > 0) return;
    SharedRenderer.shared = undefined;
    this.buffer.removeEventListener('webglcontextrestored', this.onRestored);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /**
   * Draws on a canvas, in the size of the canvas.
   *
   * @param pixelRatio pixels of the canvas per CSS pixel
   * @returns whether the drawing was painted; false while the context is lost
   */
  paint({ scene, camera, paper }: Drawing, canvas: HTMLCanvasElement, pixelRatio: number): boolean {
    const { buffer, renderer } = this;
    const { width, height } = canvas;
    const sheet = canvas.getContext('2d', { alpha: false });
    if (!sheet || this.context.isContextLost()) return false;
    // Setting a ratio reallocates the drawing buffer.
    if (pixelRatio !== renderer.getPixelRatio()) renderer.setPixelRatio(pixelRatio);
    const inCssPixels = (pixels: number): number => pixels / pixelRatio;
    // The buffer only grows; smaller frames are drawn in its lower left corner. One more pixel makes up for rounding.
    if (buffer.width < width || buffer.height < height) {
      const [most, highest] = [Math.max(buffer.width, width + 1), Math.max(buffer.height, height + 1)];
      renderer.setSize(inCssPixels(most), inCssPixels(highest), false);
    }
    renderer.setViewport(0, 0, inCssPixels(width), inCssPixels(height));
    renderer.setScissor(0, 0, inCssPixels(width), inCssPixels(height));
    renderer.setClearColor(paper);
    renderer.render(scene, camera);
    // The frame must be copied in the same task, because the drawing buffer is not preserved.
    sheet.drawImage(buffer, 0, buffer.height - height, width, height, 0, 0, width, height);
    return true;
  }

  private readonly onRestored = (): void => {
    for (const redraw of this.users) redraw();
  };
}
