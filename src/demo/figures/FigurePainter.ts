import { WebGLRenderer } from 'three';
import type { FigureDrawing } from './FigureDrawing.js';

/**
 * Pixels to a pixel of the page, whatever the screen has: panels are small, and strokes of two pixels would be coarse in
 * them. As a pen drawing made for reduction.
 */
const PIXEL_RATIO = 2;

/**
 * Renders panels one after the other in one graphics context, of which a browser gives only a few to a page, and copies
 * each to the canvas it is shown in.
 */
export class FigurePainter {
  private readonly renderer: WebGLRenderer;

  constructor(
    private readonly context: WebGL2RenderingContext,
    paper: string,
  ) {
    this.renderer = new WebGLRenderer({ canvas: context.canvas, context });
    this.renderer.setClearColor(paper, 1);
    this.renderer.setScissorTest(true);
  }

  /**
   * Draws a panel in the size of its canvas. Returns whether it did: without a graphics context it cannot.
   *
   * @param pixelRatio pixels of the canvas to a pixel of the page
   */
  paint(drawing: FigureDrawing, canvas: HTMLCanvasElement, pixelRatio: number): boolean {
    const { renderer, context } = this;
    if (context.isContextLost()) return false;
    const buffer = context.canvas;
    const [width, height] = [canvas.width, canvas.height].map((size) =>
      Math.round((size * PIXEL_RATIO) / pixelRatio),
    ) as [number, number];
    // It only grows, and smaller panels are drawn in its lower left corner.
    if (buffer.width < width || buffer.height < height) {
      renderer.setSize(Math.max(buffer.width, width), Math.max(buffer.height, height), false);
    }
    renderer.setViewport(0, 0, width, height);
    renderer.setScissor(0, 0, width, height);
    renderer.render(drawing.scene, drawing.camera);
    const sheet = canvas.getContext('2d', { alpha: false });
    if (!sheet) return false;
    sheet.imageSmoothingQuality = 'high';
    // In the same task: the drawing buffer is not kept for longer.
    sheet.drawImage(buffer, 0, buffer.height - height, width, height, 0, 0, canvas.width, canvas.height);
    return !context.isContextLost();
  }
}
