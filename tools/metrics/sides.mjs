import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** The least share of seen pixels that show the same surface as plain three.js. */
const LEAST_SAME = 0.995;

/**
 * Compares the surfaces that are seen in our pictures of glTF files with those in pictures of plain three.js, and prints a table.
 *
 * @param server a Vite server that listens
 * @param page a page of the browser
 * @param names of folders with further files, or parts of the names of files
 * @returns the files in which too few are the same, one per line
 */
export async function printSides(server, page, names) {
  const { sidedFiles } = await server.ssrLoadModule('/tools/metrics/sidedFiles.ts');
  const folders = names.filter((name) => existsSync(name));
  const wanted = names.filter((name) => !existsSync(name));
  const made = sidedFiles().map(({ name, bytes }) => [{ name, base64: Buffer.from(bytes).toString('base64') }]);
  const others = [
    ...['../shared/models', '../shared/cases/30-gltf-extras', '../shared/cases/38-invisible-hitbox', 'examples/models'],
    ...folders,
  ].flatMap((folder) => filesIn(join(folder.startsWith('/') ? '' : root, folder)));
  const sources = [...made, ...others].filter(
    ([{ name }]) => wanted.length === 0 || wanted.some((part) => name.includes(part)),
  );
  await page.goto(`${server.resolvedUrls.local[0]}tools/metrics/sides.html`);
  await page.waitForFunction(() => typeof window.measureSeenSurfaces === 'function');
  const missed = [];
  console.log('| file | the same surface |');
  console.log('| --- | ---: |');
  for (const files of sources) {
    const same = await page
      .evaluate((files) => window.measureSeenSurfaces(files), files)
      .catch((error) => String(error).split('\n')[0]);
    const text = typeof same === 'number' ? `${(100 * same).toFixed(2)} %` : same;
    console.log(`| ${files[0].name} | ${text} |`);
    if (!(same >= LEAST_SAME)) missed.push(`${files[0].name}: ${text}`);
  }
  console.log(`${sources.length - missed.length} of ${sources.length} files`);
  return missed;
}

/** The glTF files of a folder, each with the files it refers to. */
function filesIn(folder) {
  if (!existsSync(folder)) return [];
  // One case must be refused.
  const models = readdirSync(folder).filter((name) => /\.(glb|gltf)$/.test(name) && name !== 'required.gltf');
  return models.map((name) => [name, ...companions(join(folder, name))].map((one) => read(join(folder, one))));
}

const read = (path) => ({ name: basename(path), base64: readFileSync(path, 'base64') });

function companions(path) {
  if (extname(path) !== '.gltf') return [];
  const { buffers = [], images = [] } = JSON.parse(readFileSync(path, 'utf8'));
  const names = [...buffers, ...images].flatMap(({ uri }) => (uri && !uri.startsWith('data:') ? [uri] : []));
  return names.filter((name) => existsSync(join(dirname(path), name)));
}
