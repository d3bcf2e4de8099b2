import { defineConfig, type UserConfig } from 'vite';

/**
 * The library: ES modules, three external. Built in two passes, so that both results stand alone: `index` with the worker
 * inlined, and with `--mode worker` the same worker as one file, which a page under a strict Content-Security-Policy can
 * serve from its own origin.
 */
export default defineConfig(
  ({ mode }): UserConfig => ({
    // The default base would turn the worker's address into an absolute one, broken for every consumer.
    base: './',
    publicDir: false,
    // Inlined as text, where no consumer's minifier reaches it.
    worker: { format: 'es', rolldownOptions: { output: { minify: true } } },
    build: {
      target: 'es2022',
      // Readable as it is, so it needs no source map; and a map of the inlined worker would have no address.
      minify: false,
      sourcemap: false,
      emptyOutDir: mode !== 'worker',
      lib: {
        entry: mode === 'worker' ? { 'bake.worker': 'src/worker/bake.worker.ts' } : { index: 'src/index.ts' },
        formats: ['es'],
      },
      rolldownOptions: { external: [/^three($|\/)/] },
    },
  }),
);
