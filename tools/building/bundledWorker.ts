import { build, type Plugin, type Rolldown } from 'vite';

const QUERY = '?bundled';

/**
 * Gives a worker as text, with everything that it imports: `import text from './bake.worker.js?bundled'`. Vite's own `?worker&inline` adds a
 * data: address, into which minifiers fold the whole text once more.
 *
 * @param plugins of the worker's own build
 */
export function bundledWorker(plugins: () => Plugin[] = () => []): Plugin {
  let isServed = false;
  return {
    name: 'bundled-worker',
    enforce: 'pre',
    configResolved({ command }) {
      isServed = command === 'serve';
    },
    async resolveId(source, importer) {
      if (!source.endsWith(QUERY)) return undefined;
      const resolved = await this.resolve(source.slice(0, -QUERY.length), importer);
      return resolved && `${resolved.id}${QUERY}`;
    },
    async load(id) {
      if (!id.endsWith(QUERY)) return undefined;
      // A development server sends the worker's modules one by one, as they are now.
      if (isServed) return `export default 'import ' + JSON.stringify(import.meta.url.replace(/[?].*/, ''));`;
      const bundle = await bundled(id.slice(0, -QUERY.length), plugins());
      for (const module of bundle.moduleIds) if (!module.startsWith('\0')) this.addWatchFile(module);
      return `export default ${JSON.stringify(bundle.code)};`;
    },
  };
}

/** The worker in one module, as short as it gets: no minifier of a page looks into a text. */
async function bundled(input: string, plugins: Plugin[]): Promise<Rolldown.OutputChunk> {
  const result = await build({
    configFile: false,
    logLevel: 'error',
    plugins,
    build: {
      write: false,
      minify: true,
      target: 'es2022',
      modulePreload: false,
      rolldownOptions: { input, output: { codeSplitting: false } },
    },
  });
  return (result as Rolldown.RolldownOutput).output[0];
}
