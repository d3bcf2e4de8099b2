import type { Settings } from '../../viewer/settings/settings.js';
import { drawnView } from '../elements/viewSize.js';
import { cutToDrawing, type PrintPlan, planPrint, sheetOnView } from '../print/print.js';
import { LostContextError } from '../viewport/ContextLoss.js';
import { PictureSession } from '../viewport/PictureSession.js';
import type { Viewport } from '../viewport/Viewport.js';
import { raiseCurtain } from './raiseCurtain.js';

const LOST =
  'The graphics card let go of the drawing while it was being saved. There is no picture; save it again when the drawing is back, smaller if that fails too.';

/**
 * Draws a picture behind a curtain, with frames on hold. @param draw receives the plan of the picture: its part of the view and its size
 */
export async function behindCurtain<Result>(
  viewport: Viewport,
  settings: Settings,
  signal: AbortSignal,
  draw: (session: PictureSession, plan: PrintPlan) => Promise<Result>,
): Promise<Result> {
  const curtain = raiseCurtain(viewport, settings.paper);
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
    curtain.lower();
  }
}
