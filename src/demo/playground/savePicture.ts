import { cutToDrawing, describePrint, drawPicture, planPrint, sheetOnView, ZipWriter } from '../print/print.js';
import { LostContextError } from '../stage/LostContextError.js';
import { LAYERS } from '../stage/layers.js';
import { download } from './download.js';
import { raiseCurtain } from './raiseCurtain.js';
import type { SaveDrawing } from './SaveDrawing.js';
import { drawnView } from './viewSize.js';

const LOST =
  'The graphics card let go of the drawing while it was being saved, so there is no picture. Save it again when the drawing is back; if that fails too, choose a smaller one.';

/** Saves the picture that the settings ask for: one PNG, or its layers in an archive. */
export const savePicture: SaveDrawing = async (scene, settings, name, report, signal) => {
  const curtain = raiseCurtain(scene, settings.paper);
  const { view } = scene;
  const { sheet } = view;
  try {
    const whole = planPrint(settings, drawnView(scene));
    view.sheet = sheetOnView(settings, drawnView(scene));
    scene.hold(Math.max(whole.width, whole.height));
    const plan = settings.pictureCrop === 'drawing' ? await cutToDrawing(scene, whole, signal) : whole;
    const progressOf = (part: number, parts: number) => (progress: number) =>
      report('drawing the picture', (part + progress) / parts);
    if (settings.pictureLayers === 'one') {
      const look = { ground: settings.pictureGround };
      download(await drawPicture(scene, plan, look, { signal, onProgress: progressOf(0, 1) }), `${name}.png`);
    } else {
      const zip = new ZipWriter();
      for (const [i, layer] of LAYERS.entries()) {
        const options = { signal, onProgress: progressOf(i, LAYERS.length) };
        const content = await drawPicture(scene, plan, { ground: 'transparent', layer }, options);
        await zip.add(`${name}-${i + 1}-${layer}.png`, content);
      }
      download(zip.end(), `${name}-layers.zip`);
    }
    return `Saved: ${describePrint(plan)}.`;
  } catch (error) {
    throw error instanceof LostContextError ? new LostContextError(LOST) : error;
  } finally {
    view.sheet = sheet;
    scene.release();
    curtain.lower();
  }
};
