import { type BundledDrawing, bundleFolder, isOfBundle, readBundle } from './bundle.js';
import { ModelError } from './common/ModelError.js';
import { baseName, extensionOf, MAX_BYTES, type ModelFile, withoutGz } from './common/ModelFile.js';

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
type Archive<Format> = { format: Format } | { files: ModelFile[]; drawing?: BundledDrawing };

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

/** The unpacked size that is allowed for every archive, however small. */
const SMALL_BYTES = 64 * 1024 * 1024;
/** The maximum compression ratio. Models shrink to a tenth, the most regular ones to a fiftieth; a higher ratio is a decompression bomb. */
const MAX_RATIO = 64;

/** The most bytes that packed ones may unpack to. */
const limitOf = (packedBytes: number, most = MAX_BYTES): number =>
  Math.min(most, Math.max(SMALL_BYTES, MAX_RATIO * packedBytes));

const tooLarge = (name: string, limit: number): ModelError =>
  new ModelError(`${name} unpacks to more than ${Math.round(limit / 2 ** 20)} MB, which is too much for its size.`);

/**
 * Unpacks bytes that begin with the gzip magic number, and returns others as they are. Some servers declare a `.gz` file as content
 * encoding, and the browser has unpacked it already.
 *
 * @param maxBytes after unpacking
 * @throws ModelError if they are damaged, or as soon as the unpacked size exceeds the limits
 */
export async function gunzip(bytes: Uint8Array, name: string, maxBytes: number): Promise<Uint8Array> {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  const limit = limitOf(bytes.length, maxBytes);
  const chunks: Uint8Array[] = [];
  let length = 0;
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream('gzip'));
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read().catch(() => {
      throw new ModelError(`${name} could not be unpacked: it is damaged or was cut short.`);
    });
    if (done) break;
    chunks.push(value);
    length += value.length;
    if (length > limit) {
      await reader.cancel().catch(() => {});
      throw tooLarge(name, limit);
    }
  }
  const whole = new Uint8Array(length);
  let offset = 0;
  for (const chunk of chunks) {
    whole.set(chunk, offset);
    offset += chunk.length;
  }
  return whole;
}

const MAX_ENTRIES = 10_000;

/** A file in an archive. */
export interface ZipEntry {
  path: string;
  /** Unpacked size in bytes according to the archive; no more bytes are unpacked. */
  size: number;
  packedSize: number;
}

/**
 * Lists the files of an archive without unpacking them.
 *
 * @throws ModelError if it is damaged, or there are too many
 */
async function listZip(bytes: Uint8Array, name: string): Promise<ZipEntry[]> {
  const entries: ZipEntry[] = [];
  await unzip(bytes, name, (entry) => {
    if (entries.push(entry) <= MAX_ENTRIES) return false;
    throw new ModelError(`${name} holds more than ${MAX_ENTRIES.toLocaleString('en')} files, too many for a page.`);
  });
  return entries;
}

/** @throws ModelError if the files are too large together, or their compression ratio is too high */
function checkSizes(entries: readonly ZipEntry[], name: string): void {
  const packed = entries.reduce((sum, entry) => sum + entry.packedSize, 0);
  if (entries.reduce((sum, { size }) => sum + size, 0) > limitOf(packed)) throw tooLarge(name, limitOf(packed));
}

/** Unpacks the wanted files of an archive, by path. @throws ModelError if it is damaged */
export async function unzip(
  bytes: Uint8Array,
  name: string,
  isWanted: (entry: ZipEntry) => boolean,
): Promise<Map<string, Uint8Array>> {
  const { unzipSync } = await import('three/addons/libs/fflate.module.js');
  try {
    const files = unzipSync(bytes, {
      filter: ({ name: path, size: packedSize, originalSize }) =>
        // A file stored without compression takes its packed size, whatever size the archive states.
        !path.endsWith('/') && isWanted({ path, packedSize, size: Math.max(packedSize, originalSize) }),
    });
    return new Map(Object.entries(files));
  } catch (error) {
    if (error instanceof ModelError) throw error;
    throw new ModelError(`${name} could not be unpacked: it is damaged, was cut short or is locked.`);
  }
}
