import type { ModelFile } from '../../viewer/files/readModel.js';
import { formDrawn } from '../../viewer/settings/settingValues.js';
import type { SaveDrawing } from './download.js';
import { finerModel, type HowRead } from './finerModel.js';
import { savePicture } from './savePicture.js';

/**
 * Saves the picture as `savePicture` does, from more triangles than the page draws, which are freed afterwards.
 *
 * @param files of the simplified model
 * @param choice how the files are read
 */
export const saveFiner =
  (files: readonly ModelFile[], choice: HowRead = {}): SaveDrawing =>
  async (viewport, settings, name, report, signal) => {
    const { model } = viewport;
    const { geometry, triangles, simplified } = await finerModel(files, viewport, settings, report, signal, choice);
    try {
      if (viewport.model !== model) throw new Error('another model was opened meanwhile.');
      viewport.finer = geometry;
      const { kind, size, pixelsPerRadius } = await savePicture(viewport, settings, name, report, signal);
      // Form lines of the finer mesh have other singular points.
      const anew = formDrawn(settings) ? ', lines laid anew' : '';
      if (!simplified) return `Saved as ${kind} from all triangles${anew}: ${size}.`;
      const millions = (triangles / 1e6).toFixed(1);
      const pixels = (pixelsPerRadius * simplified.error).toFixed(1);
      return `Saved as ${kind} from ${millions} million triangles${anew}: up to ${pixels} px off.`;
    } finally {
      viewport.finer = undefined;
      geometry.dispose();
    }
  };
