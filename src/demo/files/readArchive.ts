import { type BundledDrawing, bundleFolder, isOfBundle, readBundle } from './bundle.js';
import { baseName, extensionOf, withoutGz } from './fileName.js';
import { ModelError } from './ModelError.js';
import type { ModelFile } from './ModelFile.js';
import { MODEL_EXTENSIONS } from './sniffFormat.js';
import { checkSizes, listZip, unzip, type ZipEntry } from './zip.js';

/** What may belong to a model. */
const COMPANIONS = ['mtl', 'bin', 'png', 'jpg', 'jpeg', 'webp', 'bmp', 'gif', 'tga'];

/** A ZIP archive: itself a model, or a folder of files, which may come with how they are drawn. */
export type Archive = { format: '3mf' | 'usd' } | { files: ModelFile[]; drawing?: BundledDrawing };

/**
 * Looks into a ZIP archive, and unpacks it if it is not a model in itself.
 *
 * @throws ModelError if it is damaged or too large, or there is no model in it
 */
export async function readArchive(bytes: Uint8Array, name: string): Promise<Archive> {
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
  if (!wanted.some(({ path }) => isModel(path))) {
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

const isModel = (path: string): boolean =>
  isUseful({ path }) && MODEL_EXTENSIONS.includes(extensionOf(withoutGz(path)) ?? '');

/** Whether a file may be of use. macOS adds files of its own to archives, in the names of the others. */
function isUseful({ path }: Pick<ZipEntry, 'path'>): boolean {
  const extension = extensionOf(withoutGz(path)) ?? '';
  if (/^__MACOSX\//.test(path) || baseName(path).startsWith('.') || extension === 'zip') return false;
  return COMPANIONS.includes(extension) || MODEL_EXTENSIONS.includes(extension);
}
