import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

/** The model that an address without a drawing of its own shows. */
const FIRST_MODEL = /\/dragon_vrip_res3\.ply-[^/]*\.gz$/;

/** Modules that every drawing needs, but which are fetched only when it asks for them. */
const FIRST_MODULES = [
  '/src/worker/kinds/inlineIndexedWorker.ts',
  '/src/material/parts/lines.ts',
  '/src/viewer/drawing/modelOfMesh.ts',
];

/** The script that reads models. */
const MODEL_WORKER = /\/model\.worker-[^/]*\.js$/;

/**
 * Runs in a worker: browsers take up to half a second to set up their first graphics context, which blocks who asks for it. Says who draws.
 */
const GRAPHICS = `let name;
try {
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  // Browsers allow a page few contexts.
  gl.getExtension('WEBGL_lose_context').loseContext();
} catch {}
postMessage(name);
close();
`;

/**
 * The script that runs before the first modules are loaded: graphics are set up, and a worker fetches and reads the first model, if the address asks
 * for no other. `rendererAhead` and `takeReadAhead` take what comes of it. Where this script comes late, the page has done so itself.
 */
const scriptAhead = (graphics: string, model: string, worker: string): string => `if (!self.hatchingHasBegun) {
try {
  const worker = new Worker(${JSON.stringify(graphics)});
  self.hatchingRenderer = new Promise((resolve) => {
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = () => resolve();
    setTimeout(resolve, 2000);
  });
} catch {}
if (location.hash.length < 2 && !history.state?.drawing) {
  const url = new URL(${JSON.stringify(model)}, document.baseURI).href;
  try {
    const worker = new Worker(${JSON.stringify(worker)}, { type: 'module', name: 'model' });
    const files = fetch(url).then(async (response) => {
      if (!response.ok) throw new Error('the server answered ' + response.status);
      return [{ name: 'dragon.ply.gz', content: new Blob([await response.arrayBuffer()]) }];
    });
    const ahead = { url, files, worker, messages: [], hasFailed: false };
    worker.onmessage = ({ data }) => ahead.messages.push(data);
    worker.onerror = () => { ahead.hasFailed = true; };
    files.then((content) => worker.postMessage(content)).catch(() => {});
    self.hatchingReadAhead = ahead;
  } catch {}
}
}
`;

/**
 * Has the built playground begin what its first drawing needs beside fetching its first scripts, and not after they have run: fetch
 * the worker in which it is prepared, and read the first model.
 */
export const fetchedAhead: Plugin = {
  name: 'fetched-ahead',
  apply: 'build',
  enforce: 'post',
  generateBundle(_, bundle) {
    const page = bundle['index.html'];
    if (page?.type !== 'asset') this.error('There is no index.html, which fetchedAhead.ts looks for.');
    const modules = new Set<string>();
    let found = 0;
    for (const chunk of Object.values(bundle)) {
      if (chunk.type !== 'chunk' || !FIRST_MODULES.some((path) => chunk.facadeModuleId?.endsWith(path))) continue;
      found++;
      for (const name of [chunk.fileName, ...chunk.imports]) modules.add(name);
    }
    const model = Object.keys(bundle).find((name) => FIRST_MODEL.test(name));
    const worker = Object.keys(bundle).find((name) => MODEL_WORKER.test(name));
    if (found < FIRST_MODULES.length || !model || !worker)
      this.error('fetchedAhead.ts names a module, a model or a worker that is no part of the playground.');
    const emit = (name: string, source: string): string => {
      const fileName = `assets/${name}-${createHash('sha256').update(source).digest('hex').slice(0, 8)}.js`;
      this.emitFile({ type: 'asset', fileName, source });
      return fileName;
    };
    const name = emit('ahead', scriptAhead(emit('graphics', GRAPHICS), model, worker));
    const html = String(page.source);
    const links = [...modules]
      .filter((file) => !html.includes(file))
      .map((file) => `    <link rel="modulepreload" crossorigin href="./${file}">\n`);
    page.source = html
      .replace(
        /^ *<script type="module"/m,
        (first) => `    <script async fetchpriority="high" src="./${name}"></script>\n${first}`,
      )
      .replace('  </head>', `${links.join('')}  </head>`);
  },
};
