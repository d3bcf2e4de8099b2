import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer, type RequestListener } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize, sep } from 'node:path';

const types: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
};

/**
 * Serves folders below the given prefixes on a free port, and nothing else.
 *
 * @param folders - by prefix, for instance `{ '/three/': '…/node_modules/three' }`; the longest prefix that matches is taken
 * @param headers - sent with every file
 */
export async function serveFolders(folders: Record<string, string>, headers: Record<string, string> = {}) {
  const server = createServer(answerFrom(folders, headers));
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}`,
    close: () =>
      new Promise<void>((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

/** Answers requests with the files of folders, as {@link serveFolders} does: like a host of static files, which answers a folder with its index.html. */
export function answerFrom(folders: Record<string, string>, headers: Record<string, string> = {}): RequestListener {
  const prefixes = Object.keys(folders).sort((a, b) => b.length - a.length);
  return (request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname);
    const prefix = prefixes.find((candidate) => path.startsWith(candidate)) ?? '';
    const folder = normalize(`${folders[prefix] ?? ''}${sep}`);
    const place = join(folder, path.slice(prefix.length));
    const isFolder = place.startsWith(folder) && existsSync(place) && statSync(place).isDirectory();
    if (prefix !== '' && isFolder && !path.endsWith('/')) {
      response.writeHead(301, { Location: `${path}/` }).end();
      return;
    }
    const file = isFolder ? join(place, 'index.html') : place;
    if (prefix === '' || !file.startsWith(folder) || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { 'Content-Type': types[extname(file)] ?? 'application/octet-stream', ...headers });
    createReadStream(file).pipe(response);
  };
}
