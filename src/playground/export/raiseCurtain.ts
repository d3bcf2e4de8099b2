import { page } from '../elements/page.js';
import type { Viewport } from '../viewport/Viewport.js';

/** A copy of the drawing that covers the canvas during an export. */
interface Curtain {
  /** Shows another picture instead, whole, on paper. */
  show(picture: HTMLCanvasElement): void;
  /** Removes the curtain. */
  lower(): void;
}

/**
 * Covers the drawing with a copy and disables everything but Cancel, while a picture is drawn in tiles, or a video frame by frame, on the
 * same canvas.
 */
export function raiseCurtain(viewport: Viewport, paper: string): Curtain {
  const { card, bar } = page;
  const copy = document.createElement('canvas');
  copy.className = 'curtain';
  copy.setAttribute('aria-hidden', 'true');
  // Drawn and copied in one task, because the canvas does not keep its content.
  viewport.frames.draw();
  const { canvas } = viewport.frames;
  const { width, height } = Object.assign(copy, { width: canvas.width, height: canvas.height });
  const context = copy.getContext('2d');
  context?.drawImage(canvas, 0, 0);
  canvas.after(copy);
  const focused = document.activeElement;
  for (const part of [page.viewport, card, bar]) part.inert = true;
  return {
    show(picture) {
      if (!context) return;
      const scale = Math.min(width / picture.width, height / picture.height);
      const [wide, high] = [scale * picture.width, scale * picture.height];
      context.fillStyle = paper;
      context.fillRect(0, 0, width, height);
      context.drawImage(picture, (width - wide) / 2, (height - high) / 2, wide, high);
    },
    lower() {
      for (const part of [page.viewport, card, bar]) part.inert = false;
      if (focused instanceof HTMLElement) focused.focus({ preventScroll: true });
      copy.remove();
    },
  };
}
