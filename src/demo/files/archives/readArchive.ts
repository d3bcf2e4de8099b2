import { baseName, extensionOf, withoutGz } from '../common/fileName.js';
import { ModelError } from '../common/ModelError.js';
import type { ModelFile } from '../common/ModelFile.js';
import { type BundledDrawing, bundleFolder, isOfBundle, readBundle } from './bundle.js';
import { checkSizes, listZip, unzip, type ZipEntry } from './zip.js';

/** What may belong to a model. */
const COMPANIONS = ['mtl', 'bin', 'png', 'jpg', 'jpeg', 'webp', 'bmp', 'gif', 'tga'];

/** A ZIP archive: itself a model, or a folder of files, which may come with how they are drawn. */
export type Archive = { format: '3mf' | 'usd' } | { files: ModelFile[]; drawing?: BundledDrawing };

/**
 * Looks into a ZIP archive, and unpacks it if it is not a model in itself.
 *
 * @param modelExtensions those of files that are models, without the dot
 * @throws ModelError if it is damaged or too large, or there is no model in it
 */
export async function readArchive(
  bytes: Uint8Array,
  name: string,
  modelExtensions: readonly string[],
): Promise<Archive> {
  const extensionIn = (extensions: readonly string[], { path }: Pick<ZipEntry, 'path'>): boolean =>
    extensions.includes(extensionOf(withoutGz(path)) ?? '');
  const isModel = (entry: Pick<ZipEntry, 'path'>): boolean => isUsable(entry) && extensionIn(modelExtensions, entry);
  const isUseful = (entry: Pick<ZipEntry, 'path'>): boolean =>
    isModel(entry) || (isUsable(entry) && extensionIn(COMPANIONS, entry));
  const entries = await listZip(bytes, name);
  const folder = bundleFolder(entries);
  if (folder !== undefined) {
    const isWanted = (entry: ZipEntry): boolean => isOfBundle(entry, folder);
    checkSizes(entries.filter(isWanted), name);
    return readBundle(await unzip(bytes, name, isWanted), folder, name);
  }
  const format = packageFormat(entries);
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

function packageFormat(entries: readonly ZipEntry[]): '3mf' | 'usd' | undefined {
  if (entries.some(({ path }) => /^\/?3D\/[^/]*\.model$/i.test(path))) return '3mf';
  // The first file of a package in USDZ is its outermost layer.
  return /\.usd[ac]?$/i.test(entries[0]?.path ?? '') ? 'usd' : undefined;
}

/** macOS adds files of its own to archives, in the names of the others. Archives in archives are not unpacked. */
const isUsable = ({ path }: Pick<ZipEntry, 'path'>): boolean =>
  !/^__MACOSX\//.test(path) && !baseName(path).startsWith('.') && extensionOf(withoutGz(path)) !== 'zip';
