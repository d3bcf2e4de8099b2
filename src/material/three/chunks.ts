/** Known in three.js 0.170 to 0.187: which of its shader chunks there are, and what they are expected to say. */
import { ShaderChunk } from 'three';
import { loadChecks } from '../firstDraw/loadChecks.js';
import type { ChunkName } from './warnOfChunk.js';

/** Warns once, in one sentence, of a chunk that is not what was expected. @returns `isKnown` */
export function expectChunk(name: ChunkName, isKnown: boolean): boolean {
  // If the sentence cannot be loaded, the page draws without it.
  if (!isKnown)
    loadChecks?.()
      .then((checks) => checks.warnOfChunk(name))
      .catch(() => {});
  return isKnown;
}

/** three's chunk with which the shadows of older versions unpack depth. A later version may no longer have it. */
export const packingChunk = (): string => ('packing' in ShaderChunk ? '#include <packing>' : '');
