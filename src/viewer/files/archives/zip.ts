import { ModelError } from '../common/ModelError.js';
import { MAX_BYTES } from '../common/ModelFile.js';

/** The unpacked size that is allowed for every archive, however small; larger archives may unpack to MAX_RATIO times their size. */
const SMALL_BYTES = 64 * 1024 * 1024;
const MAX_RATIO = 64;
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
export async function listZip(bytes: Uint8Array, name: string): Promise<ZipEntry[]> {
  const entries: ZipEntry[] = [];
  await unzip(bytes, name, (entry) => {
    if (entries.push(entry) <= MAX_ENTRIES) return false;
    throw new ModelError(`${name} holds more than ${MAX_ENTRIES.toLocaleString('en')} files, too many for a page.`);
  });
  return entries;
}

/** @throws ModelError if the files are too large together, or their compression ratio is too high */
export function checkSizes(entries: readonly ZipEntry[], name: string): void {
  const packed = entries.reduce((sum, entry) => sum + entry.packedSize, 0);
  const limit = Math.min(MAX_BYTES, Math.max(SMALL_BYTES, MAX_RATIO * packed));
  if (entries.reduce((sum, { size }) => sum + size, 0) <= limit) return;
  throw new ModelError(
    `${name} unpacks to more than ${Math.round(limit / 2 ** 20)} MB, which is too much for its size.`,
  );
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
