import { baseName } from '../../files/common/fileName.js';
import type { ModelFile } from '../../files/readModel.js';

/** The model that is shown: the files it was read from, and the names of those it asks for beside. */
export interface ShownFiles {
  files: readonly ModelFile[];
  missing: readonly string[];
  /** Those out of an archive, if it was one. */
  unpacked?: readonly ModelFile[] | undefined;
}

/** What files are for. `pictures` may be a map, or may have come here by mistake. */
export type DropKind = 'model' | 'map' | 'pictures';

/**
 * Tells what dropped files are for.
 *
 * @param isAtMap whether the map is being looked at, so that pictures are for it
 * @returns what they are, and the files to read: with those of the shown model, if they are what it lacks
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
