import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';

const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.mjs': 'text/javascript' };

/** The share of the pixels of the canvas that are dark where strokes are drawn. */
const STROKES = 0.02;

/**
 * @typedef {object} Loading
 * @property {number} atOnce the bytes of the scripts that the page loads before it hatches anything, compressed by gzip
 * @property {string[]} later the names of the scripts that it requests from then on until strokes are drawn
 * @property {number} laterBytes their bytes, compressed by gzip
 * @property {number} waves the times that a request waits for the answer to an earlier one, the first of them included
 */

/**
 * Loads a page that hatches a scene, as a server sends it that compresses with gzip, and counts what it requests until its canvas
 * shows strokes. Each request is answered when the page has made all that do not depend on its answer: the answers come in waves.
 * Scripts of three.js, under `/three/`, do not count. The page sets `window.isHatching` before it hatches anything.
 *
 * @param {import('playwright').Page} page
 * @param {{ folder: string, file: string, three: string }} built the folder that a bundler wrote, the page in it, and three's package
 * @returns {Promise<Loading>}
 */
export async function measureLoading(page, { folder, file, three }) {
  const bodyOf = (/** @type {string} */ path) => {
    const place = path.startsWith('/three/') ? join(three, path.slice(7)) : join(folder, path);
    return existsSync(place) ? gzipSync(readFileSync(place)) : undefined;
  };
  const server = createServer(({ url }, response) => {
    const path = new URL(url ?? '/', 'http://localhost').pathname;
    const body = bodyOf(path);
    const type = TYPES[/** @type {keyof typeof TYPES} */ (extname(path))] ?? 'application/octet-stream';
    response.writeHead(body ? 200 : 404, { 'Content-Type': type, 'Content-Encoding': 'gzip' }).end(body);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  /** @type {import('playwright').Route[]} */
  let held = [];
  /** @type {string[]} */
  const atOnce = [];
  /** @type {string[][]} */
  const waves = [];
  const pathOf = (/** @type {import('playwright').Route} */ route) => new URL(route.request().url()).pathname;
  await page.route(/\.m?js$/, (route) => (pathOf(route).startsWith('/three/') ? route.continue() : held.push(route)));
  try {
    await page.goto(`http://127.0.0.1:${port}/${file}`, { waitUntil: 'commit' });
    while (!(await page.evaluate(hasStrokes, STROKES))) {
      if (held.length === 0) continue;
      for (let before = 0; before < held.length; await page.evaluate(whenIdle)) before = held.length;
      const answered = held;
      held = [];
      if (await page.evaluate(() => 'isHatching' in window)) waves.push(answered.map(pathOf));
      else atOnce.push(...answered.map(pathOf));
      await Promise.all(
        answered.map(async (route) => {
          await route.continue();
          await (await route.request().response())?.finished();
        }),
      );
    }
  } finally {
    await new Promise((resolve) => {
      server.close(resolve);
      server.closeAllConnections();
    });
  }
  const bytes = (/** @type {string[]} */ paths) => paths.reduce((sum, path) => sum + (bodyOf(path)?.length ?? 0), 0);
  const later = waves.flat();
  return { atOnce: bytes(atOnce), later, laterBytes: bytes(later), waves: waves.length };
}

/** Runs in the page: whether enough of its canvas is dark. @param {number} share */
function hasStrokes(share) {
  const canvas = document.querySelector('canvas');
  if (!canvas) return false;
  const { width, height } = canvas;
  const copy = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
  if (!copy) return false;
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, width, height);
  let dark = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i] < 100 && data[i + 3] === 255) dark++;
  return dark > share * width * height;
}

/** Runs in the page: resolves when it has had nothing to do several times. */
async function whenIdle() {
  for (let times = 0; times < 5; times++) await new Promise((resolve) => requestIdleCallback(resolve));
}
