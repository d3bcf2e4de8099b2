import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { bundledWorker } from '../tools/building/bundledWorker.js';
import { libraryEntries } from '../tools/building/libraryEntries.js';
import { shortShaders } from '../tools/building/shortShaders.js';
import { noticeCheck, noticeFile } from '../tools/notice/noticePlugin.js';
import { readExamples } from './readExamples.mjs';

const file = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The examples as static pages. They import the library by its package name, as its users do. */
export default defineConfig({
  root: file('.'),
  base: './',
  publicDir: false,
  plugins: [shortShaders, bundledWorker(() => [noticeCheck()]), noticeFile, noticeCheck()],
  resolve: { alias: libraryEntries('./src/', 'ts', 'index') },
  worker: { format: 'es', plugins: () => [noticeCheck()] },
  build: {
    outDir: '../dist-examples',
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1500,
    // A module that is preloaded by text of its own would need the policy of strict-csp to allow that.
    modulePreload: { polyfill: false },
    rolldownOptions: { input: ['index.html', ...readExamples().map(({ folder }) => `${folder}/index.html`)].map(file) },
  },
});
