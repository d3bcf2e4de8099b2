import { baseName, extensionOf, withoutGz } from '../common/fileName.js';
import { ModelError } from '../common/ModelError.js';
import type { ModelFile } from '../common/ModelFile.js';
import { type BundledDrawing, bundleFolder, isOfBundle, readBundle } from './bundle.js';
import { checkSizes, listZip, unzip, type ZipEntry } from './zip.js';

/** A model format that may be a ZIP archive itself. */
interface Package {
  /** Whether an archive with these paths is a model of the format. */
  isPackage?: (paths: readonly string[]) => boolean;
}

/** The formats and extensions to look for. Extensions are in lower case and without the dot. */
interface Wanted<Format extends Package> {
  formats: readonly Format[];
  modelExtensions: readonly string[];
  /** Extensions of files that models refer to. */
  companionExtensions: readonly string[];
}

/** A ZIP archive: a model in itself, or unpacked files, with their look if the archive is a bundle. */
export type Archive<Format> = { format: Format } | { files: ModelFile[]; drawing?: BundledDrawing };

/**
 * Inspects a ZIP archive, and unpacks it unless it is a model in itself.
 *
 * @throws ModelError if it is damaged or too large, or contains no model
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
  // The loaders of these formats unpack all files.
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

/** Excludes the metadata files that macOS adds to archives, and archives in archives. */
const isUsable = (entry: Named): boolean =>
  !/^__MACOSX\//.test(entry.path) && !baseName(entry.path).startsWith('.') && typeOf(entry) !== 'zip';
