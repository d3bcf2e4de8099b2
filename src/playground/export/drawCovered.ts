import type { Settings } from '../../viewer/settings/settings.js';
import { drawnView, page } from '../page/page.js';
import { cutToDrawing, type PrintPlan, planPrint, sheetOnView } from '../print/print.js';
import { LostContextError } from '../viewport/ContextLoss.js';
import { PictureSession } from '../viewport/PictureSession.js';
import type { Viewport } from '../viewport/Viewport.js';

const LOST =
  'The graphics card let go of the drawing while it was being saved. There is no picture; save it again when the drawing is back, smaller if that fails too.';

/**
 * Draws a picture while a copy covers the canvas, with frames on hold.
 *
 * @param draw receives the plan of the picture: its part of the view and its size
 */
export async function drawCovered<Result>(
  viewport: Viewport,
  settings: Settings,
  signal: AbortSignal,
  draw: (session: PictureSession, plan: PrintPlan) => Promise<Result>,
): Promise<Result> {
  const cover = coverCanvas(viewport, settings.paper);
  const session = new PictureSession(viewport);
  const goBack = viewport.view.composeFor(sheetOnView(settings, drawnView(viewport)));
  try {
    const whole = planPrint(settings, drawnView(viewport));
    session.hold(Math.max(whole.width, whole.height));
    const plan = settings.pictureCrop === 'drawing' ? await cutToDrawing(session, whole, signal) : whole;
    return await draw(session, plan);
  } catch (error) {
    throw error instanceof LostContextError ? new LostContextError(LOST) : error;
  } finally {
    goBack();
    session.release();
    cover.remove();
  }
}

/** A copy of the drawing that covers the canvas during an export. */
interface Cover {
  /** Shows another picture instead, whole, on paper. */
  show(picture: HTMLCanvasElement): void;
  /** Removes the cover. */
  remove(): void;
}

/**
 * Covers the drawing with a copy and disables everything but Cancel, while a picture is drawn in tiles, or a video frame by frame, on the
 * same canvas.
 */
export function coverCanvas(viewport: Viewport, paper: string): Cover {
  const { card, bar } = page;
  const copy = document.createElement('canvas');
  copy.className = 'cover';
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
    remove() {
      for (const part of [page.viewport, card, bar]) part.inert = false;
      if (focused instanceof HTMLElement) focused.focus({ preventScroll: true });
      copy.remove();
    },
  };
}
