import { baseName, extensionOf, withoutGz } from '../common/fileName.js';
import { ModelError } from '../common/ModelError.js';
import type { ModelFile } from '../common/ModelFile.js';
import { type BundledDrawing, bundleFolder, isOfBundle, readBundle } from './bundle.js';
import { checkSizes, listZip, unzip, type ZipEntry } from './zip.js';

/** A format that an archive may have in itself. */
interface Package {
  /** Whether an archive with these files is a model of the format. */
  isPackage?: (paths: readonly string[]) => boolean;
}

/** What an archive is searched for. Extensions are in lower case and without the dot. */
interface Wanted<Format extends Package> {
  formats: readonly Format[];
  modelExtensions: readonly string[];
  /** Extensions of files that models may refer to. */
  companionExtensions: readonly string[];
}

/** A ZIP archive: itself a model, or a folder of files, which may come with how they are drawn. */
export type Archive<Format> = { format: Format } | { files: ModelFile[]; drawing?: BundledDrawing };

/**
 * Looks into a ZIP archive, and unpacks it if it is not a model in itself.
 *
 * @throws ModelError if it is damaged or too large, or there is no model in it
 */
export async function readArchive<Format extends Package>(
  bytes: Uint8Array,
  name: string,
  { formats, modelExtensions, companionExtensions }: Wanted<Format>,
): Promise<Archive<Format>> {
  const isModel = (entry: Named): boolean => isUsable(entry) && modelExtensions.includes(typeOf(entry));
  const isUseful = (entry: Named): boolean =>
    isModel(entry) || (isUsable(entry) && companionExtensions.includes(typeOf(entry)));
  const entries = await listZip(bytes, name);
  const folder = bundleFolder(entries);
  if (folder !== undefined) {
    const isWanted = (entry: ZipEntry): boolean => isOfBundle(entry, folder);
    checkSizes(entries.filter(isWanted), name);
    return readBundle(await unzip(bytes, name, isWanted), folder, name);
  }
  const paths = entries.map(({ path }) => path);
  const format = formats.find(({ isPackage }) => isPackage?.(paths));
  // Loaders of such files unpack all that is in them.
  const wanted = format ? entries : entries.filter(isUseful);
  checkSizes(wanted, name);
  if (format) return { format };
  if (!wanted.some(isModel)) {
    throw new ModelError(`${name} holds no model that this page can read.`);
  }
  const unpacked = await unzip(bytes, name, isUseful);
  const files = [...unpacked].map(([path, content]) => ({
    name: baseName(path),
    content: new Blob([content as Uint8Array<ArrayBuffer>]),
  }));
  return { files };
}

type Named = Pick<ZipEntry, 'path'>;

const typeOf = ({ path }: Named): string => extensionOf(withoutGz(path)) ?? '';

/** macOS adds files of its own to archives, in the names of the others. Archives in archives are not unpacked. */
const isUsable = (entry: Named): boolean =>
  !/^__MACOSX\//.test(entry.path) && !baseName(entry.path).startsWith('.') && typeOf(entry) !== 'zip';
