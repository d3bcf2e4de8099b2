import type { ModelFile } from '../../viewer/files/readModel.js';
import { page } from '../elements/page.js';
import type { MapLoader } from './MapLoader.js';
import type { ModelLoader } from './ModelLoader.js';
import { sortDrop } from './sortDrop.js';

/** Shows dropped files as a model, or draws with them as a map. Asks the user if they could be either. */
export async function openDropped(
  dropped: readonly ModelFile[],
  { modelLoader, mapLoader }: { modelLoader: ModelLoader; mapLoader: MapLoader },
): Promise<void> {
  const { kind, files } = sortDrop(dropped, modelLoader.shownFiles, !page.contactSheet.sheet.hidden);
  if (kind === 'model') await modelLoader.showFiles(files);
  else if (kind === 'map' || (await askForStrokes(files))) await mapLoader.showFiles(files);
}

async function askForStrokes(files: readonly ModelFile[]): Promise<boolean> {
  const { askForStrokes } = await import('./ask.js');
  return askForStrokes(files.map(({ name }) => name));
}
