import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build, preview } from 'vite';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const outDir = 'tests/output/bench/playground';

/** Builds the playground into a folder and serves it, as a visitor would get it. */
export async function servePlayground() {
  await build({ root, logLevel: 'error', build: { outDir, emptyOutDir: true } });
  const server = await preview({
    root,
    logLevel: 'error',
    build: { outDir },
    preview: { host: '127.0.0.1', port: 0, open: false },
  });
  return { folder: join(root, outDir), address: server.resolvedUrls.local[0], close: () => server.close() };
}
