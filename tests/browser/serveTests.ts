import { existsSync } from 'node:fs';
import { createServer, type Plugin } from 'vite';

/** The pages of the browser tests, as the test server serves them, but with another version of three.js. */
export async function serveTests(three: string): Promise<{ url: string; close(): Promise<void> }> {
  const server = await createServer({
    mode: 'test',
    logLevel: 'error',
    plugins: [withoutPlayground(three)],
    resolve: { alias: { three } },
    cacheDir: `node_modules/.vite-test-${three}`,
    server: { host: '127.0.0.1', port: 0 },
  });
  await server.listen();
  return { url: server.resolvedUrls?.local[0] ?? '', close: () => server.close() };
}

/** The playground runs with the newest version alone: older ones do not have all the loaders that it names. */
const withoutPlayground = (three: string): Plugin => ({
  name: 'without-playground',
  config: ({ optimizeDeps }) => {
    if (!optimizeDeps) return;
    optimizeDeps.entries = ['tests/gpu/*.html'];
    optimizeDeps.include = optimizeDeps.include?.filter((name) => {
      const addon = /^three\/addons\/(.*)/.exec(name)?.[1];
      return addon === undefined || existsSync(`node_modules/${three}/examples/jsm/${addon}`);
    });
  },
});
