import type { Report } from '../../drawing/Report.js';
import {
  cutToDrawing,
  describePrint,
  drawPicture,
  type PrintPlan,
  planPrint,
  sheetOnView,
  ZipWriter,
} from '../../print/print.js';
import type { Settings } from '../../settings/settings.js';
import { LostContextError } from '../../stage/LostContextError.js';
import { LAYERS } from '../../stage/layers.js';
import { PictureSession } from '../../stage/PictureSession.js';
import type { Stage } from '../../stage/Stage.js';
import { drawnView } from '../elements/viewSize.js';
import { download } from './download.js';
import { raiseCurtain } from './raiseCurtain.js';
import type { SaveDrawing } from './SaveDrawing.js';

/** The most pixels of a picture that other programs can be expected to paste from the clipboard. */
const MOST_COPIED_PIXELS = 64_000_000;

const LOST =
  'The graphics card let go of the drawing while it was being saved. There is no picture; save it again when the drawing is back, smaller if that fails too.';

/** Saves the picture that the settings ask for: one PNG, or its layers in an archive. */
export const savePicture: SaveDrawing = (stage, settings, name, report, signal) =>
  behindCurtain(stage, settings, signal, async (session, plan) => {
    if (settings.pictureLayers === 'one') {
      download(await drawWhole(session, settings, plan, report, signal), `${name}.png`);
      return `Saved as PNG: ${describePrint(plan)}.`;
    }
    const zip = new ZipWriter();
    for (const [i, layer] of LAYERS.entries()) {
      const onProgress = (progress: number) => report('drawing the picture', (i + progress) / LAYERS.length);
      const content = await drawPicture(session, plan, { ground: 'transparent', layer }, { signal, onProgress });
      await zip.add(`${name}-${i + 1}-${layer}.png`, content);
    }
    download(zip.end(), `${name}-layers.zip`);
    return `Saved as ${LAYERS.length} PNG images in a ZIP: ${describePrint(plan)}.`;
  });

/** Draws the picture that the settings ask for as one PNG, for the clipboard. */
export const drawForClipboard: SaveDrawing<Blob> = (stage, settings, _name, report, signal) =>
  behindCurtain(stage, settings, signal, (session, plan) => {
    if (plan.width * plan.height > MOST_COPIED_PIXELS)
      throw new Error('the picture is too large for a clipboard. Save it, or choose a smaller size.');
    return drawWhole(session, settings, plan, report, signal);
  });

/** Holds frames behind a curtain while a picture is drawn. @param draw gets the plan of the picture: its part of the view and its size */
async function behindCurtain<Result>(
  stage: Stage,
  settings: Settings,
  signal: AbortSignal,
  draw: (session: PictureSession, plan: PrintPlan) => Promise<Result>,
): Promise<Result> {
  const curtain = raiseCurtain(stage, settings.paper);
  const session = new PictureSession(stage);
  const { view } = stage;
  const { sheet } = view;
  try {
    const whole = planPrint(settings, drawnView(stage));
    view.sheet = sheetOnView(settings, drawnView(stage));
    session.hold(Math.max(whole.width, whole.height));
    const plan = settings.pictureCrop === 'drawing' ? await cutToDrawing(session, whole, signal) : whole;
    return await draw(session, plan);
  } catch (error) {
    throw error instanceof LostContextError ? new LostContextError(LOST) : error;
  } finally {
    view.sheet = sheet;
    session.release();
    curtain.lower();
  }
}

function drawWhole(
  session: PictureSession,
  { pictureGround: ground }: Settings,
  plan: PrintPlan,
  report: Report,
  signal: AbortSignal,
): Promise<Blob> {
  const onProgress = (progress: number) => report('drawing the picture', progress);
  return drawPicture(session, plan, { ground }, { signal, onProgress });
}
