import { defineConfig, type Plugin, type UserConfig } from 'vite';
import { shortShaders } from './shortShaders.js';

/** Further entries, by the mode that builds them. */
const ENTRIES: Record<string, Record<string, string>> = {
  worker: { 'bake.worker': 'src/worker/bake.worker.ts' },
  command: { command: 'src/command/main.ts' },
  react: { react: 'src/react/index.ts' },
  element: { element: 'src/element/element.ts' },
};

/** Vite makes the Blob of an inlined worker when the module is loaded, so no bundler may leave it out. */
const pureWorkerBlob: Plugin = {
  name: 'pure-worker-blob',
  enforce: 'post',
  transform(code, id) {
    if (!id.includes('?worker&inline')) return null;
    const made = /^(const blob = )(.*);$/m;
    if (!made.test(code)) this.error('The code of an inlined worker has changed: mend pureWorkerBlob.');
    return { code: code.replace(made, '$1/* @__PURE__ */ (() => $2)();'), map: null };
  },
};

/** The library holds no code of others: nobody who uses it has to name them. */
const nothingOfOthers: Plugin = {
  name: 'nothing-of-others',
  generateBundle(_options, bundle) {
    for (const chunk of Object.values(bundle)) {
      const strangers = chunk.type === 'chunk' ? chunk.moduleIds.filter((id) => id.includes('/node_modules/')) : [];
      if (strangers.length > 0) this.error(`The library would hold code of others: ${strangers.join(', ')}.`);
    }
  },
};

/**
 * The library: ES modules, three external. Built in passes, so that each result stands alone: `index` with the worker
 * inlined; with `--mode worker` the same worker as one file, which a page under a strict Content-Security-Policy can serve
 * from its own origin; with `--mode command` the command for Node; with `--mode react` the components and with `--mode element` the web
 * component, which import `index` as any page does, so that there is one copy of it.
 */
export default defineConfig(
  ({ mode }): UserConfig => ({
    // The default base would turn the worker's address into an absolute one, broken for every consumer.
    base: './',
    plugins: [shortShaders, pureWorkerBlob, nothingOfOthers],
    publicDir: false,
    // Inlined as text, where no consumer's minifier reaches it.
    worker: { format: 'es', plugins: () => [nothingOfOthers], rolldownOptions: { output: { minify: true } } },
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
      rolldownOptions: {
        external: [/^three($|\/)/, /^node:/, /^react($|\/)/, '@react-three/fiber', 'three-hatching'],
        // What is loaded when it is needed, under its own name; and what several files need.
        output: {
          chunkFileNames: '[name].js',
          // Says that it runs in the browser, to frameworks that run components on the server.
          ...(mode === 'react' && { banner: "'use client';" }),
          // A page without a bundler needs no entry in its import map for that.
          ...(mode === 'element' && { paths: { 'three-hatching': './index.js' } }),
          codeSplitting: { groups: [{ name: 'shared', minShareCount: 2 }] },
        },
      },
    },
  }),
);
