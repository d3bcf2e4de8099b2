import { build, preview } from 'vite';

/**
 * Builds the playground into a folder and serves it, as users meet it: bundled, under its Content-Security-Policy.
 *
 * @param {string} root of the project
 * @param {string} outDir
 * @returns {Promise<{ address: string, close(): Promise<void> }>}
 */
export async function serveBuilt(root, outDir) {
  await build({ root, logLevel: 'error', build: { outDir, emptyOutDir: true } });
  const site = await preview({ root, logLevel: 'error', build: { outDir }, preview: { host: '127.0.0.1', port: 0 } });
  return { address: site.resolvedUrls.local[0], close: () => site.close() };
}
