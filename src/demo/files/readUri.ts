import type { FindFile } from './FindFile.js';

/**
 * The bytes of a data URI, or of a file that was dropped together with the model. Nothing is fetched from elsewhere.
 */
export async function readUri(uri: string, findFile: FindFile): Promise<Uint8Array | undefined> {
  return uri.startsWith('data:') ? new Uint8Array(await (await fetch(uri)).arrayBuffer()) : findFile(uri);
}
