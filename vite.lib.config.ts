import { defineConfig, type UserConfig } from 'vite';

const ENTRIES: Record<string, Record<string, string>> = {
  worker: { 'bake.worker': 'src/worker/bake.worker.ts' },
  command: { command: 'src/command/main.ts' },
};

/**
 * The library: ES modules, three external. Built in passes, so that each result stands alone: `index` with the worker
 * inlined; with `--mode worker` the same worker as one file, which a page under a strict Content-Security-Policy can serve
 * from its own origin; and with `--mode command` the command for Node.
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
      emptyOutDir: ENTRIES[mode] === undefined,
      lib: {
        entry: ENTRIES[mode] ?? { index: 'src/index.ts' },
        formats: ['es'],
      },
      rolldownOptions: { external: [/^three($|\/)/, /^node:/] },
    },
  }),
);
