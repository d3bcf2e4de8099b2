import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

/** The model that an address without a drawing of its own shows. */
const FIRST_MODEL = /\/dragon_vrip_res3\.ply-[^/]*\.gz$/;

/** Modules that every drawing needs, but which are fetched only when it asks for them. */
const FIRST_MODULES = ['/src/worker/WorkerPool.ts', '/src/worker/inlineWorker.ts'];

/**
 * Has the built playground fetch what its first drawing needs beside its first scripts, and not after they have run: the worker in
 * which it is prepared, and the first model, if the address asks for no other.
 */
export const fetchedAhead: Plugin = {
  name: 'fetched-ahead',
  apply: 'build',
  enforce: 'post',
  generateBundle(_, bundle) {
    const page = bundle['index.html'];
    if (page?.type !== 'asset') this.error('There is no index.html, which fetchedAhead.ts looks for.');
    const modules = new Set<string>();
    for (const chunk of Object.values(bundle)) {
      if (chunk.type !== 'chunk' || !FIRST_MODULES.some((path) => chunk.facadeModuleId?.endsWith(path))) continue;
      for (const name of [chunk.fileName, ...chunk.imports]) modules.add(name);
    }
    const model = Object.keys(bundle).find((name) => FIRST_MODEL.test(name));
    if (modules.size < FIRST_MODULES.length || !model)
      this.error('fetchedAhead.ts names a module or a model that is no part of the playground.');
    // Not a link to preload: on a slow machine browsers complain of one that is not used within seconds.
    const script = `location.hash.length<2&&!history.state?.drawing&&fetch(${JSON.stringify(model)}).then((file)=>file.blob()).catch(()=>{})`;
    const name = `assets/ahead-${createHash('sha256').update(script).digest('hex').slice(0, 8)}.js`;
    this.emitFile({ type: 'asset', fileName: name, source: script });
    const html = String(page.source);
    const links = [...modules]
      .filter((file) => !html.includes(file))
      .map((file) => `    <link rel="modulepreload" crossorigin href="./${file}">\n`);
    page.source = html
      .replace(/^ *<script type="module"/m, (first) => `    <script async src="./${name}"></script>\n${first}`)
      .replace('  </head>', `${links.join('')}  </head>`);
  },
};
