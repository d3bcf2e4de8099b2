import { gzipSync } from 'node:zlib';
import type { Plugin } from 'vite';

/** The most that the scripts of a page may weigh which it fetches before it draws, in bytes, compressed by gzip. */
const MAX_BYTES = 265_500;

/** Fails a build whose pages fetch too much before their first drawing. */
export const firstPartCheck: Plugin = {
  name: 'first-part-check',
  apply: 'build',
  generateBundle(_, bundle) {
    for (const entry of Object.values(bundle)) {
      if (entry.type !== 'chunk' || !entry.isEntry) continue;
      const files = new Set([entry.fileName]);
      let bytes = 0;
      // The loop also visits what is added to the set meanwhile.
      for (const file of files) {
        const chunk = bundle[file];
        if (chunk?.type !== 'chunk') continue;
        for (const imported of chunk.imports) files.add(imported);
        bytes += gzipSync(chunk.code).length;
      }
      if (bytes > MAX_BYTES)
        this.error(
          `The first part of ${entry.name} has ${bytes} compressed bytes, more than ${MAX_BYTES}: fetch some of it later.`,
        );
    }
  },
};
