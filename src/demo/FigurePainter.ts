import { WebGLRenderer } from 'three';
import type { FigureDrawing } from './FigureDrawing.js';

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

  /** Draws a panel in the size of its canvas. Returns whether it did: without a graphics context it cannot. */
  paint(drawing: FigureDrawing, canvas: HTMLCanvasElement): boolean {
    const { renderer, context } = this;
    const { width, height } = canvas;
    if (context.isContextLost()) return false;
    const buffer = context.canvas;
    // It only grows, and small panels are drawn in its lower left corner.
    if (buffer.width < width || buffer.height < height) {
      renderer.setSize(Math.max(buffer.width, width), Math.max(buffer.height, height), false);
    }
    renderer.setViewport(0, 0, width, height);
    renderer.setScissor(0, 0, width, height);
    renderer.render(drawing.scene, drawing.camera);
    // In the same task: the drawing buffer is not kept for longer.
    canvas
      .getContext('2d', { alpha: false })
      ?.drawImage(buffer, 0, buffer.height - height, width, height, 0, 0, width, height);
    return !context.isContextLost();
  }
}
