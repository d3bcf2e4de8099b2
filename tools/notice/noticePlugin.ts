import type { Plugin } from 'vite';
import { unnoticed, writeNotice } from './writeNotice.js';

const NAME = 'NOTICE.txt';

/** Writes NOTICE.txt beside the built pages, and serves it where they are developed. */
export const noticeFile: Plugin = {
  name: 'notice-file',
  configureServer({ middlewares }) {
    middlewares.use((request, response, next) => {
      if (request.url?.split('?')[0] !== `/${NAME}`) next();
      else response.setHeader('Content-Type', 'text/plain; charset=utf-8').end(writeNotice());
    });
  },
  generateBundle() {
    this.emitFile({ type: 'asset', fileName: NAME, source: writeNotice() });
  },
};

/** Fails a build that bundles code or models of others which the notice does not name. It serves pages and workers. */
export const noticeCheck = (): Plugin => ({
  name: 'notice-check',
  apply: 'build',
  generateBundle() {
    const missing = unnoticed(this.getModuleIds());
    if (missing.length > 0)
      this.error(`NOTICE.txt does not name ${missing.join(', ')}: add it in tools/notice/contents.ts.`);
  },
});
