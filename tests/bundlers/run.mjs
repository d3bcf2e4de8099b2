/**
 * `npm run test:bundlers`: builds a small page of the packed library with every bundler and looks whether all of them draw the very
 * same picture, and what the three lines of the README load. The bundlers are installed into a temporary folder, in the versions that are newest; no part of `npm test`.
 * `npm run test:bundlers -- parcel next` tries some.
 */
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { launchOptions } from '../../tools/browser/launchOptions.mjs';
import { measureLoading } from '../../tools/browser/measureLoading.mjs';
import { recipes } from './recipes.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const pages = join(root, 'tests/consumers/pages');
const PORT = Number(process.env.HATCH_PORT ?? 41730) + 1000;
const words = process.argv.slice(2).map((word) => word.toLowerCase());
const chosen = recipes.filter(
  ({ name }) => words.length === 0 || words.some((word) => name.toLowerCase().includes(word)),
);

const work = mkdtempSync(join(tmpdir(), 'three-hatching-bundlers-'));
const env = {
  ...process.env,
  CI: 'true',
  NEXT_TELEMETRY_DISABLED: '1',
  PARCEL_WORKERS: '1',
  BROWSERSLIST_IGNORE_OLD_DATA: '1',
};
const run = (cwd, [command, ...args]) =>
  execFileSync(command, args, { cwd, env, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

run(root, ['npm', 'run', '--silent', 'build:lib']);
const [{ filename }] = JSON.parse(run(root, ['npm', 'pack', '--json', '--pack-destination', work]));
const three = JSON.parse(run(root, ['npm', 'pkg', 'get', 'devDependencies.three']));

const browser = await chromium.launch(await launchOptions());
/** The first picture, which all others must equal. */
let first;
const failed = [];
try {
  for (const recipe of chosen) {
    try {
      const picture = await picturedBy(recipe);
      const ink = picture.filter((value) => value < 64).length / picture.length;
      if (!(ink > 0.02 && ink < 0.6)) throw new Error(`There is no hatched cube in the picture: ${ink} of it is ink.`);
      first ??= picture;
      const others = picture.filter((value, i) => value !== first[i]).length;
      if (picture.length !== first.length || others > 0) throw new Error(`${others} pixels are others than before.`);
      console.log(`✓ ${recipe.name}`);
    } catch (error) {
      failed.push(recipe.name);
      console.error(`✘ ${recipe.name}\n${error.stdout ?? ''}${error.stderr ?? ''}${error.stack}`);
    }
  }
} finally {
  await browser.close();
  rmSync(work, { recursive: true, force: true });
}
console.log(`${chosen.length - failed.length} passed, ${failed.length} failed`);
process.exitCode = failed.length > 0 || chosen.length === 0 ? 1 : 0;

/** Installs, builds, serves and opens the page of a recipe. The red of every pixel that it draws. */
async function picturedBy({ name, packages, files, commands, folder, serve, manifest, loading, most }) {
  const project = join(work, name.replaceAll(/\W+/g, '-').toLowerCase());
  mkdirSync(project, { recursive: true });
  const dependencies = { 'three-hatching': `file:${join(work, filename)}`, three, ...packages };
  writeFileSync(
    join(project, 'package.json'),
    JSON.stringify({ name: 'bundled', private: true, type: 'module', dependencies, ...manifest }),
  );
  for (const page of ['plain.js', 'renderHatchedCube.js']) cpSync(join(pages, page), join(project, page));
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(project, path)), { recursive: true });
    writeFileSync(join(project, path), text);
  }
  run(project, ['npm', 'install', '--no-audit', '--no-fund', '--loglevel=error']);
  for (const command of commands) run(project, command);
  if (loading) await checkLoading(project, loading, most);
  const server = serve ? await served(project, serve) : await previewed(project, folder);
  try {
    return await opened(server.url, packages.next !== undefined);
  } finally {
    await server.close();
  }
}

/** Builds the three lines of the README, and checks what they load. */
async function checkLoading(project, command, most) {
  for (const file of ['threeLines.js', 'threeLines.html']) cpSync(join(pages, file), join(project, file));
  run(project, command);
  const folder = join(project, 'loading');
  cpSync(join(pages, 'threeLines.html'), join(folder, 'threeLines.html'));
  const page = await browser.newPage();
  try {
    const three = join(project, 'node_modules/three');
    const { atOnce, later, laterBytes, waves } = await measureLoading(page, { folder, file: 'threeLines.html', three });
    const loads = { atOnce, later: laterBytes, requests: later.length, waves };
    console.log(`  loads ${JSON.stringify(loads)}`);
    for (const [name, limit] of Object.entries(most))
      if (loads[name] > limit) throw new Error(`The three lines load more than ${name} ${limit}.`);
  } finally {
    await page.close();
  }
}

async function previewed(project, folder) {
  const server = await preview({
    configFile: false,
    root: project,
    logLevel: 'error',
    build: { outDir: folder },
    preview: { host: '127.0.0.1', port: PORT },
  });
  return { url: server.resolvedUrls.local[0], close: () => server.close() };
}

async function served(project, [command, ...args]) {
  const url = `http://127.0.0.1:${PORT}/`;
  const child = spawn(
    command,
    args.map((one) => one.replace('PORT', String(PORT))),
    { cwd: project, env, stdio: 'ignore', detached: true },
  );
  for (let tries = 0; tries < 300; tries++) {
    await new Promise((go) => setTimeout(go, 200));
    if (
      await fetch(url).then(
        (answer) => answer.ok,
        () => false,
      )
    )
      break;
  }
  return { url, close: () => void process.kill(-child.pid) };
}

async function opened(url, hasComponents) {
  const page = await browser.newPage();
  const problems = [];
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  try {
    await page.goto(url);
    await page.waitForFunction(() => window.rendering !== undefined, undefined, { timeout: 60_000 });
    // A development server reloads the page when it meets a package for the first time.
    const picture = await page.waitForFunction(() => window.rendering, undefined, { timeout: 60_000 });
    if (hasComponents) await page.waitForFunction(() => window.hatchedMaterials === 1, undefined, { timeout: 60_000 });
    if (problems.length > 0) throw new Error(problems.join('\n'));
    return await picture.jsonValue();
  } catch (error) {
    throw new Error(`${problems.join('\n')}\n${error.message}`);
  } finally {
    await page.close();
  }
}
