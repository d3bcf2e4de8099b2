import { WebGLRenderer } from 'three';
import type { FigureDrawing } from './FigureDrawing.js';
import { PIXEL_RATIO } from './figurePixels.js';

/**
 * Renders all panels in one WebGL context, because browsers limit the number of contexts, and copies each to its own
 * canvas.
 */
export class FigurePainter {
  private readonly renderer: WebGLRenderer;

  constructor(private readonly context: WebGL2RenderingContext) {
    this.renderer = new WebGLRenderer({ canvas: context.canvas, context });
    this.renderer.setScissorTest(true);
  }

  /**
   * Draws a panel in the size of its canvas.
   *
   * @param pixelRatio pixels of the canvas per CSS pixel
   * @returns false if the graphics context is lost
   */
  paint(drawing: FigureDrawing, canvas: HTMLCanvasElement, pixelRatio: number): boolean {
    const { renderer, context } = this;
    if (context.isContextLost()) return false;
    const buffer = context.canvas;
    const [width, height] = [canvas.width, canvas.height].map((size) =>
      Math.round((size * PIXEL_RATIO) / pixelRatio),
    ) as [number, number];
    // The buffer only grows. Smaller panels are drawn in its lower left corner.
    if (buffer.width < width || buffer.height < height) {
      renderer.setSize(Math.max(buffer.width, width), Math.max(buffer.height, height), false);
    }
    renderer.setViewport(0, 0, width, height);
    renderer.setScissor(0, 0, width, height);
    renderer.setClearColor(drawing.paper, 1);
    renderer.render(drawing.scene, drawing.camera);
    const target = canvas.getContext('2d', { alpha: false });
    if (!target) return false;
    target.imageSmoothingQuality = 'high';
    // In the same task as the rendering, because the drawing buffer is not kept for longer.
    target.drawImage(buffer, 0, buffer.height - height, width, height, 0, 0, canvas.width, canvas.height);
    return !context.isContextLost();
  }
}
