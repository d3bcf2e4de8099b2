import { gzipSync } from 'node:zlib';
import type { Plugin } from 'vite';

/** Of all scripts that a page fetches before it draws, packed, in bytes. */
const MAX_BYTES = 256_000;

/** Fails a build whose pages fetch too much at first. What is needed later is fetched later. */
export const firstPartCheck: Plugin = {
  name: 'first-part-check',
  apply: 'build',
  generateBundle(_, bundle) {
    for (const entry of Object.values(bundle)) {
      if (entry.type !== 'chunk' || !entry.isEntry) continue;
      const files = new Set([entry.fileName]);
      let bytes = 0;
      // A set that grows is gone through to its end.
      for (const file of files) {
        const chunk = bundle[file];
        if (chunk?.type !== 'chunk') continue;
        for (const imported of chunk.imports) files.add(imported);
        bytes += gzipSync(chunk.code).length;
      }
      if (bytes > MAX_BYTES)
        this.error(
          `The first part of ${entry.name} has ${bytes} bytes packed, more than ${MAX_BYTES}: fetch some of it later.`,
        );
    }
  },
};
