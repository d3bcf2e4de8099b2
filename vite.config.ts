import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

/** The playground. It imports the library by its package name; `--mode use-build` runs it on the built library. */
export default defineConfig(({ mode }) => ({
  // Relative, so that the built playground can lie in any folder of any host.
  base: './',
  resolve: {
    alias: mode === 'use-build' ? {} : { 'three-hatching': fileURLToPath(new URL('./src/index.ts', import.meta.url)) },
  },
  assetsInclude: ['**/*.ply.gz'],
  worker: { format: 'es' as const },
  build: { outDir: 'dist-demo', target: 'es2022', chunkSizeWarningLimit: 1500 },
}));
