import { createServer } from 'vite';

/** The pages of the browser tests, as the test server serves them, but with another version of three.js. */
export async function serveTests(three: string): Promise<{ url: string; close(): Promise<void> }> {
  const server = await createServer({
    mode: 'test',
    logLevel: 'error',
    resolve: { alias: { three } },
    cacheDir: `node_modules/.vite-test-${three}`,
    server: { host: '127.0.0.1', port: 0 },
  });
  await server.listen();
  return { url: server.resolvedUrls?.local[0] ?? '', close: () => server.close() };
}
