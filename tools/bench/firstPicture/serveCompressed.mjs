import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';

const TYPES = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.webp': 'image/webp',
  '.wasm': 'application/wasm',
};
const COMPRESSED = ['.html', '.js', '.css', '.json', '.svg'];

/** Serves a folder as hosts of static pages do: what is text is compressed. */
export async function serveCompressed(folder) {
  const answers = new Map();
  const answerOf = (path) => {
    const type = extname(path);
    const content = readFileSync(join(folder, path));
    return COMPRESSED.includes(type)
      ? { body: gzipSync(content), headers: { 'Content-Type': TYPES[type], 'Content-Encoding': 'gzip' } }
      : { body: content, headers: { 'Content-Type': TYPES[type] ?? 'application/octet-stream' } };
  };
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const path = normalize(pathname.endsWith('/') ? `${pathname}index.html` : pathname);
    try {
      if (!answers.has(path)) answers.set(path, answerOf(path));
      const { body, headers } = answers.get(path);
      response.writeHead(200, headers).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}
