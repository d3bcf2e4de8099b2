import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build, preview } from 'vite';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const outDir = 'tests/output/bench/playground';

let built;

/** Builds the playground into a folder, once for all benchmarks of a run, and serves it, as a visitor would get it. */
export async function servePlayground() {
  built ??= build({ root, logLevel: 'error', build: { outDir, emptyOutDir: true } });
  await built;
  const server = await preview({
    root,
    logLevel: 'error',
    build: { outDir },
    preview: { host: '127.0.0.1', port: 0, open: false },
  });
  return { folder: join(root, outDir), address: server.resolvedUrls.local[0], close: () => server.close() };
}
