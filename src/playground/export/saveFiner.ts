import type { ModelFile } from '../../viewer/files/readModel.js';
import { formDrawn } from '../../viewer/settings/settingValues.js';
import { finerModel } from './finerModel.js';
import type { SaveDrawing } from './SaveDrawing.js';
import { savePicture } from './savePicture.js';

/**
 * Saves the picture as `savePicture` does, from more triangles than the page draws. They are let go afterwards.
 *
 * @param files the model, which was simplified
 * @param variant the index of the variant of its materials, if one was chosen
 */
export const saveFiner =
  (files: readonly ModelFile[], variant?: number): SaveDrawing =>
  async (stage, settings, name, report, signal) => {
    const { model } = stage;
    const { geometry, triangles, simplified } = await finerModel(files, stage, settings, report, signal, variant);
    try {
      if (stage.model !== model) throw new Error('another model was opened meanwhile.');
      stage.finer = geometry;
      const { kind, size, pixelsPerRadius } = await savePicture(stage, settings, name, report, signal);
      // The form of a finer mesh has singular points of its own.
      const anew = formDrawn(settings) ? ', lines laid anew' : '';
      if (!simplified) return `Saved as ${kind} from all triangles${anew}: ${size}.`;
      const millions = (triangles / 1e6).toFixed(1);
      const pixels = (pixelsPerRadius * simplified.error).toFixed(1);
      return `Saved as ${kind} from ${millions} million triangles${anew}: up to ${pixels} px off.`;
    } finally {
      stage.finer = undefined;
      geometry.dispose();
    }
  };
