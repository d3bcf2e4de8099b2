import type { Report } from '../../viewer/drawing/buildModel.js';
import { LAYERS } from '../../viewer/sceneSetup/Ground.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { describePrint, drawPicture, nearestRadius, type PrintPlan, ZipWriter } from '../print/print.js';
import type { PictureSession } from '../viewport/PictureSession.js';
import type { SaveDrawing } from './download.js';
import { download } from './download.js';
import { drawCovered } from './drawCovered.js';

/** The maximum number of pixels of a clipboard picture; other programs may fail to paste more. */
const MOST_COPIED_PIXELS = 64_000_000;

/** A saved picture. */
export interface SavedPicture {
  /** The kind of file. */
  kind: string;
  size: string;
  /** Pixels per radius of the model at its nearest point. */
  pixelsPerRadius: number;
}

/** Saves the picture by the settings: one PNG, or its layers in an archive. */
export const savePicture: SaveDrawing<SavedPicture> = (viewport, settings, name, report, signal) =>
  drawCovered(viewport, settings, signal, async (session, plan) => {
    const saved = { size: describePrint(plan), pixelsPerRadius: nearestRadius(viewport.camera, plan) };
    if (settings.pictureLayers === 'one') {
      download(await drawWhole(session, settings, plan, report, signal), `${name}.png`);
      return { kind: 'PNG', ...saved };
    }
    const zip = new ZipWriter();
    for (const [i, layer] of LAYERS.entries()) {
      const onProgress = (progress: number) => report('drawing the picture', (i + progress) / LAYERS.length);
      const content = await drawPicture(session, plan, { ground: 'transparent', layer }, { signal, onProgress });
      await zip.add(`${name}-${i + 1}-${layer}.png`, content);
    }
    download(zip.end(), `${name}-layers.zip`);
    return { kind: `${LAYERS.length} PNG images in a ZIP`, ...saved };
  });

/** Draws the picture as one PNG for the clipboard. */
export const drawForClipboard: SaveDrawing<Blob> = (viewport, settings, _name, report, signal) =>
  drawCovered(viewport, settings, signal, (session, plan) => {
    if (plan.width * plan.height > MOST_COPIED_PIXELS)
      throw new Error('the picture is too large for a clipboard. Save it, or choose a smaller size.');
    return drawWhole(session, settings, plan, report, signal);
  });

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
