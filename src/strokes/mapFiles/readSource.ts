import { type ReadMap, readImages, readMap } from './readMapFiles.js';

/** The sources that `TonalArtMap.load` accepts. */
export type TonalArtMapSource = string | URL | readonly (string | URL)[] | readonly File[];

/** Reads the source of `TonalArtMap.load`. Rejects with the signal's reason when aborted. */
export async function readSource(
  source: TonalArtMapSource,
  signal: AbortSignal | undefined,
  onProgress: (progress: number) => void,
): Promise<ReadMap> {
  try {
    return await readFrom(source, signal, onProgress);
  } catch (error) {
    // An error caused by the abort is replaced by the signal's reason.
    signal?.throwIfAborted();
    throw error;
  }
}

function readFrom(
  source: TonalArtMapSource,
  signal: AbortSignal | undefined,
  onProgress: (progress: number) => void,
): Promise<ReadMap> {
  if (typeof source === 'string' || source instanceof URL) {
    const base = absolute(source);
    return readMap(base, (name) => fetchFile(new URL(name, base), signal), onProgress);
  }
  const items: readonly (string | URL | File)[] = Array.isArray(source) ? source : [];
  if (items.length === 0) {
    throw new TypeError('TonalArtMap.load: source is empty, but must be a URL or a list of URLs or files.');
  }
  const files = new Map<string, File>();
  for (const item of items) if (item instanceof File) files.set(item.name, item);
  if (files.size === 0) {
    const names = items.map((item) => absolute(item as string | URL));
    return readImages(names, (name) => fetchFile(new URL(name), signal), false, onProgress);
  }
  const read = async (name: string): Promise<Uint8Array> => {
    const file = files.get(name);
    if (!file) throw new Error('is missing among the files; choose it together with the others');
    return new Uint8Array(await file.arrayBuffer());
  };
  const description = [...files.keys()].find((name) => name.endsWith('.json'));
  if (description !== undefined) return readMap(description, read, onProgress);
  return readImages([...files.keys()], read, true, onProgress);
}

/** Resolves a relative URL against that of the page or, in a worker, of its script. */
function absolute(address: string | URL): string {
  const base = typeof document === 'undefined' ? globalThis.location?.href : document.baseURI;
  try {
    return new URL(address, base).href;
  } catch {
    throw new TypeError(
      `TonalArtMap.load: "${String(address)}" is a URL that cannot be resolved here (against ${base ?? 'nothing'}); pass an absolute URL, with https://.`,
    );
  }
}

async function fetchFile(url: URL, signal: AbortSignal | undefined): Promise<Uint8Array> {
  let response: Response;
  try {
    response = await fetch(url, { signal: signal ?? null });
  } catch (error) {
    throw new Error(
      `could not be fetched (${(error as Error).message}); check the address and whether its host allows it`,
    );
  }
  if (!response.ok) throw new Error(`could not be fetched (${response.status}); check the address`);
  return new Uint8Array(await response.arrayBuffer());
}
