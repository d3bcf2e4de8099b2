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

/** Fails a build that has code or models of others in it, of which the notice does not speak. For pages and workers alike. */
export const noticeCheck = (): Plugin => ({
  name: 'notice-check',
  apply: 'build',
  generateBundle() {
    const missing = unnoticed(this.getModuleIds());
    if (missing.length > 0)
      this.error(`NOTICE.txt does not speak of ${missing.join(', ')}: add it in tools/notice/contents.ts.`);
  },
});
