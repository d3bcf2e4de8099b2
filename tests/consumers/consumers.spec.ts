import { execFileSync } from 'node:child_process';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { build, createServer, type Rolldown } from 'vite';
import { expect, test } from '../browser/test.js';
import { installPackedLibrary, libraryFolder, projectFolder, root, threeFolder } from './packedLibrary.js';
import { serveFolders } from './serveFolders.js';

declare global {
  interface Window {
    rendering: Promise<number[]>;
  }
}

const STRICT_CSP =
  "default-src 'none'; script-src 'self'; worker-src 'self'; img-src data:; base-uri 'none'; object-src 'none'";

let files: string[] = [];
test.beforeAll(() => {
  files = installPackedLibrary();
});

/** The smallest bundles that a page with a build of its own can have, in bytes after gzip: what it loads at once. */
const MOST_BYTES = { HatchingMaterial: 30_000, 'HatchingMaterial, prepareHatchingGeometry, TonalArtMap': 48_000 };

test.describe('the tarball', () => {
  test('holds the library and its declarations, and nothing else', () => {
    expect(files).toEqual(
      expect.arrayContaining([
        ...['LICENSE', 'README.md', 'package.json'],
        ...['dist/index.js', 'dist/index.d.ts', 'dist/worker/bake.worker.d.ts'],
      ]),
    );
    const scripts = ['index.js', 'bake.worker.js', 'command.js']
      .flatMap((name) => withImports(name))
      .map((name) => `dist/${name}`);
    const strangers = files.filter(
      (file) => !/^(LICENSE|README\.md|package\.json|dist\/.+\.d\.ts)$/.test(file) && !scripts.includes(file),
    );
    expect(strangers).toEqual([]);
    expect(files).toEqual(expect.arrayContaining(scripts));
    expect(files.filter((file) => file.includes('demo'))).toEqual([]);
  });

  test('every file that package.json names is there', () => {
    const { exports, bin, main, types } = packageJson();
    const named = Object.values({ ...exports, ...bin, main, types } as Record<string, string | Record<string, string>>)
      .flatMap((entry) => (typeof entry === 'string' ? [entry] : Object.values(entry)))
      .map((path) => path.replace('./', ''));
    expect(files).toEqual(expect.arrayContaining(named));
  });

  test('is found by resolvers old and new, and binds no user to a version of Node', () => {
    const { exports, main, engines, peerDependencies } = packageJson();
    expect(main).toBe(exports['.'].default);
    const { resolve } = createRequire(join(projectFolder, 'any.js'));
    expect(resolve('three-hatching/package.json')).toBe(join(libraryFolder, 'package.json'));
    expect(engines).toBeUndefined();
    expect(peerDependencies).toEqual({ three: '>=0.170.0' });
  });

  test('imports three and nothing else; the worker imports nothing, the command what Node has', () => {
    const imported = withImports('index.js').flatMap(importsOf);
    expect(imported.filter((name) => name !== 'three' && !name.startsWith('./'))).toEqual([]);
    expect(importsOf('bake.worker.js')).toEqual([]);
    for (const name of importsOf('command.js')) expect(name).toMatch(/^node:/);
  });

  test('leaves nothing in a bundle that uses nothing of it, whatever the bundler is told', async () => {
    // As a copy without package.json, which says that there are no side effects.
    const copy = join(projectFolder, 'copy');
    cpSync(join(libraryFolder, 'dist'), copy, { recursive: true });
    const [{ code }] = await bundle(`import '${copy}/index.js';`);
    expect(code.replace(/import ?["']three["'];?/, '').trim()).toBe('');
  });

  for (const [names, most] of Object.entries(MOST_BYTES)) {
    test(`is small: ${names}`, async () => {
      const chunks = await bundle(`export { ${names} } from 'three-hatching';`);
      const byName = new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
      const atOnce = new Set(chunks.filter(({ isEntry }) => isEntry));
      for (const { imports } of atOnce) {
        for (const name of imports) if (byName.has(name)) atOnce.add(byName.get(name)!);
      }
      const bytes = [...atOnce].reduce((sum, { code }) => sum + gzipSync(code).length, 0);
      test.info().annotations.push({ type: 'size', description: `${bytes} bytes` });
      expect(bytes).toBeLessThanOrEqual(most);
      expect([...atOnce].map(({ code }) => code).join('')).not.toContain('// N_t, which');
    });
  }

  for (const three of ['@types/three', 'types-three-middle', 'types-three-oldest']) {
    for (const moduleResolution of ['bundler', 'nodenext']) {
      test(`has declarations that a strict compiler takes without our build tools: ${three}, ${moduleResolution}`, () => {
        const compilerOptions = {
          target: 'es2022',
          lib: ['es2023', 'dom', 'dom.iterable'],
          module: moduleResolution === 'bundler' ? 'esnext' : 'nodenext',
          moduleResolution,
          paths: { three: [join(root, 'node_modules', three)] },
          types: [],
          strict: true,
          exactOptionalPropertyTypes: true,
          noEmit: true,
          skipLibCheck: false,
        };
        writeFileSync(
          join(projectFolder, 'tsconfig.strict.json'),
          JSON.stringify({ compilerOptions, files: ['types.ts'] }),
        );
        const typescript = createRequire(import.meta.url).resolve('typescript/package.json');
        const compile = () =>
          execFileSync(process.execPath, [join(dirname(typescript), 'bin/tsc'), '--project', 'tsconfig.strict.json'], {
            cwd: projectFolder,
            encoding: 'utf8',
          });
        expect(compilerOutput(compile)).toBe('');
      });
    }
  }
});

test.describe('a hatched cube', () => {
  test('on a page with an import map and no bundler', async ({ page }) => {
    const server = await serveFolders({
      '/': projectFolder,
      '/three/': threeFolder,
      '/three-hatching/': libraryFolder,
    });
    await page.goto(`${server.url}/importMap.html`);
    expectHatching(await pixels(page));
    await server.close();
  });

  test('in a Vite development server', async ({ page }) => {
    const server = await createServer({
      configFile: false,
      root: projectFolder,
      logLevel: 'error',
      cacheDir: join(projectFolder, '.vite'),
      server: { host: '127.0.0.1', port: 0, hmr: false, watch: null },
      optimizeDeps: { include: ['three', 'three-hatching'] },
    });
    await server.listen();
    await page.goto(`${server.resolvedUrls!.local[0]}plain.html`);
    expectHatching(await pixels(page));
    await server.close();
  });

  test('in a Vite build', async ({ page }) => {
    const server = await serveFolders({ '/': await viteBuild('plain') });
    await page.goto(`${server.url}/plain.html`);
    expectHatching(await pixels(page));
    await server.close();
  });

  for (const name of ['workerImport', 'workerUrl']) {
    test(`under a strict content security policy, with createWorker (${name})`, async ({ page }) => {
      const server = await serveFolders({ '/': await viteBuild(name) }, { 'Content-Security-Policy': STRICT_CSP });
      const workers: string[] = [];
      page.on('worker', (worker) => workers.push(worker.url()));
      await page.goto(`${server.url}/${name}.html`);
      expectHatching(await pixels(page));
      expect(workers.length).toBeGreaterThan(0);
      for (const url of workers) expect(url).toMatch(new RegExp(`^${server.url}/assets/bake\\.worker`));
      await server.close();
    });
  }

  test('under a strict content security policy without createWorker: on the main thread', async ({
    page,
    pageProblems,
  }) => {
    const server = await serveFolders({ '/': await viteBuild('plain') }, { 'Content-Security-Policy': STRICT_CSP });
    await page.goto(`${server.url}/plain.html`);
    expectHatching(await pixels(page));
    // The browser reports the refused worker, and the library says what it does about it.
    expect(pageProblems).toEqual([
      expect.stringMatching(/^console error: .*worker-src 'self'/),
      expect.stringMatching(/^console warning: three-hatching: .*createWorker/),
    ]);
    pageProblems.length = 0;
    await server.close();
  });
});

const packageJson = () => JSON.parse(readFileSync(join(libraryFolder, 'package.json'), 'utf8'));

/** A file of dist and all of its own kind that it imports, at once or later. */
function withImports(file: string, known: string[] = []): string[] {
  if (known.includes(file)) return [];
  known.push(file);
  for (const name of importsOf(file)) if (name.startsWith('./')) withImports(name.slice(2), known);
  return known;
}

/** What a consumer's bundler makes of an entry, three.js apart. */
async function bundle(entry: string): Promise<Rolldown.OutputChunk[]> {
  const input = join(projectFolder, 'entry.js');
  writeFileSync(input, entry);
  const result = await build({
    configFile: false,
    root: projectFolder,
    logLevel: 'error',
    build: {
      write: false,
      modulePreload: false,
      rolldownOptions: { input, external: /^three($|\/)/, preserveEntrySignatures: 'strict' },
    },
  });
  return (result as Rolldown.RolldownOutput).output.filter((file) => file.type === 'chunk');
}

function importsOf(file: string): string[] {
  const text = readFileSync(join(libraryFolder, 'dist', file), 'utf8');
  const statements = text.matchAll(/^(?:import|export)\b[^'"`;]*?(?:from\s*)?['"]([^'"]+)['"]/gm);
  const calls = text.matchAll(/\bimport\(\s*['"]([^'"]+)['"]\s*\)/g);
  return [...new Set([...statements, ...calls].map((match) => match[1]))];
}

function compilerOutput(compile: () => string): string {
  try {
    return compile();
  } catch (error) {
    return (error as { stdout: string }).stdout;
  }
}

/** Builds one of the pages and returns the folder. */
async function viteBuild(name: string): Promise<string> {
  const outDir = join(projectFolder, `dist-${name}`);
  await build({
    configFile: false,
    root: projectFolder,
    base: './',
    logLevel: 'error',
    worker: { format: 'es' },
    build: {
      outDir,
      emptyOutDir: true,
      chunkSizeWarningLimit: 2000,
      rolldownOptions: { input: join(projectFolder, `${name}.html`) },
    },
  });
  return outDir;
}

const pixels = (page: Page) => page.evaluate(() => window.rendering);

let first: number[] | undefined;

/** The cube is there, with strokes and paper on it, and is the same for every consumer. */
function expectHatching(red: number[]): void {
  const part = (from: number, to: number) => red.filter((value) => value >= from && value < to).length / red.length;
  expect(part(0, 64), 'ink').toBeGreaterThan(0.02);
  expect(part(200, 256), 'paper').toBeGreaterThan(0.3);
  first ??= red;
  expect(red).toEqual(first);
}
