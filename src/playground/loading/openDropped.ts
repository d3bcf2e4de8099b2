import { baseName } from '../../viewer/files/common/ModelFile.js';
import type { ModelFile } from '../../viewer/files/readModel.js';
import type { MapLoader } from './MapLoader.js';
import type { ModelLoader, ShownFiles } from './ModelLoader.js';

/**
 * Shows dropped files as a model, or draws with them as a map. Asks the user if they could be either.
 *
 * @param isAtMap whether the contact sheet is open, so that pictures belong to the map
 */
export async function openDropped(
  dropped: readonly ModelFile[],
  { modelLoader, mapLoader }: { modelLoader: ModelLoader; mapLoader: MapLoader },
  isAtMap: boolean,
): Promise<void> {
  const { kind, files } = sortDrop(dropped, modelLoader.shown, isAtMap);
  if (kind === 'model') await modelLoader.showFiles(files);
  else if (kind === 'map' || (await askForStrokes(files))) await mapLoader.showFiles(files);
}

async function askForStrokes(files: readonly ModelFile[]): Promise<boolean> {
  const { askForStrokes } = await import('./ask.js');
  return askForStrokes(files.map(({ name }) => name));
}

/** The purpose of files. `pictures` may be the images of a map, or may have been dropped by mistake. */
export type DropKind = 'model' | 'map' | 'pictures';

/**
 * Determines the purpose of dropped files.
 *
 * @returns the purpose, and the files to read, including those of the shown model if the dropped files were missing from it
 */
export function sortDrop(
  files: readonly ModelFile[],
  shown: ShownFiles,
  isAtMap: boolean,
): { kind: DropKind; files: readonly ModelFile[] } {
  const names = new Set(files.map(nameOf));
  if (shown.missing.some((name) => names.has(name.toLowerCase()))) {
    return { kind: 'model', files: [...shown.files.filter((file) => !names.has(nameOf(file))), ...files] };
  }
  if (!areMapFiles(files)) return { kind: 'model', files };
  const isSavedMap = files.some(({ name }) => /\.json$/i.test(name));
  return { kind: isAtMap || isSavedMap ? 'map' : 'pictures', files };
}

const nameOf = ({ name }: ModelFile): string => baseName(name).toLowerCase();

/** Whether files can only be a tonal art map: PNG images, perhaps with the JSON file of a saved map. */
function areMapFiles(files: readonly ModelFile[]): boolean {
  return files.every(({ name }) => /\.(png|json)$/i.test(name));
}
