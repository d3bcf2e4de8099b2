import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createServer, type Plugin } from 'vite';

const QUERY = '?occlusion';
const root = fileURLToPath(new URL('../..', import.meta.url));

/**
 * `import url from 'model.ply.gz?occlusion'`: the build bakes the ambient occlusion of a model, and ships it as a file of little
 * more than a byte for each vertex. Where nothing is built, and in tests without a browser, there is no file, and the page bakes it.
 */
export const occlusionAhead: Plugin = {
  name: 'occlusion-ahead',
  enforce: 'pre',
  configResolved({ command }) {
    isBuild = command === 'build';
  },
  async resolveId(id, importer, options) {
    if (!id.endsWith(QUERY)) return undefined;
    const model = await this.resolve(id.slice(0, -QUERY.length), importer, { ...options, skipSelf: true });
    return model && `\0${model.id}${QUERY}`;
  },
  async load(id) {
    if (!id.startsWith('\0') || !id.endsWith(QUERY)) return undefined;
    if (!isBuild) return 'export default undefined;';
    const path = id.slice(1, -QUERY.length);
    const name = `${basename(path).split('.')[0]}_occlusion.bin`;
    const reference = this.emitFile({ type: 'asset', name, source: await baked(path) });
    return `export default import.meta.ROLLUP_FILE_URL_${reference};`;
  },
};

let isBuild = false;

/** Bakes by the library's own code, which is TypeScript. */
async function baked(path: string): Promise<Uint8Array> {
  const server = await createServer({
    root,
    configFile: false,
    logLevel: 'error',
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, ws: false, watch: null },
  });
  try {
    const { bakeModelOcclusion } = (await server.ssrLoadModule('/tools/building/bakeModelOcclusion.ts')) as Awaited<
      typeof import('./bakeModelOcclusion.js')
    >;
    return await bakeModelOcclusion({ name: basename(path), content: new Blob([await readFile(path)]) });
  } finally {
    await server.close();
  }
}
