import { defineConfig } from 'vite';

/** The library: ES modules, three external. The worker is inlined into `index` and also built as an entry of its own. */
export default defineConfig({
  // The default base would turn the worker's address into an absolute one, broken for every consumer.
  base: './',
  publicDir: false,
  worker: { format: 'es' },
  build: {
    target: 'es2022',
    minify: false,
    sourcemap: true,
    lib: {
      entry: { index: 'src/index.ts', 'bake.worker': 'src/worker/bake.worker.ts' },
      formats: ['es'],
    },
    rolldownOptions: { external: [/^three($|\/)/] },
  },
});
