import type { Plugin } from 'vite';

/** The path of the list in the built playground. */
const NAME = 'parts.json';

/** Packages that are imported for their data, models, and not for code. */
const MODELS = /\/node_modules\/(?!three\/)/;
/** The code for WebGPURenderer, which is as large as all the rest and fetched only when it is chosen. */
const CHOSEN = /\/src\/playground\/viewport\/(?:NodeScreen|nodeScreen)\.ts$/;

let root = '';

/** Writes a list of the scripts that the playground fetches later than its first drawing, so that it can do so before they are needed. */
export const laterParts: Plugin = {
  name: 'later-parts',
  configResolved(config) {
    root = config.root;
  },
  configureServer({ middlewares }) {
    middlewares.use((request, response, next) => {
      if (request.url?.split('?')[0] !== `/${NAME}`) next();
      else response.setHeader('Content-Type', 'application/json').end('[]');
    });
  },
  generateBundle(_, bundle) {
    const chunkOf = (file: string) => {
      const chunk = bundle[file];
      return chunk?.type === 'chunk' ? chunk : undefined;
    };
    const page = Object.values(bundle).find(
      (one) => one.type === 'chunk' && one.isEntry && one.facadeModuleId === `${root}/index.html`,
    );
    if (!page) this.error('The playground has no first script: laterParts.ts looks for that of index.html.');
    const first = new Set([page.fileName]);
    // The loop also visits what is added to the set meanwhile.
    for (const file of first) for (const imported of chunkOf(file)?.imports ?? []) first.add(imported);
    const all = new Set(first);
    for (const file of all) {
      const chunk = chunkOf(file);
      if (!chunk || [MODELS, CHOSEN].some((one) => one.test(chunk.facadeModuleId ?? ''))) all.delete(file);
      else for (const imported of [...chunk.imports, ...chunk.dynamicImports]) all.add(imported);
    }
    const later = [...all].filter((file) => !first.has(file));
    this.emitFile({ type: 'asset', fileName: NAME, source: JSON.stringify(later) });
  },
};
