import { execFile } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import type { Plugin } from 'vite';
import { answerFrom } from './serveFolders.js';

/** The path under which the test server serves the built playground. */
export const BUILT = '/built/';

const folder = fileURLToPath(new URL('../../tests/output/playground', import.meta.url));

/**
 * Serves the playground as users get it: bundled, in a folder of a server. It is built when it is first asked for, once for all tests
 * of a run. Opened like this it is there in half the time that the hundreds of modules of the source take.
 */
export const builtPlayground: Plugin = {
  name: 'built-playground',
  configureServer({ config, middlewares }) {
    const answer = answerFrom({ [BUILT]: folder });
    let built: Promise<unknown> | undefined;
    middlewares.use((request, response, next) => {
      if (!request.url?.startsWith(BUILT)) {
        next();
        return;
      }
      built ??= buildIn(config.root);
      built.then(() => answer(request, response), next);
    });
  },
};

/** Builds in a process of its own: the build sets NODE_ENV, and takes seconds in which the server would not answer. */
function buildIn(root: string): Promise<unknown> {
  const vite = join(dirname(fileURLToPath(import.meta.resolve('vite/package.json'))), 'bin/vite.js');
  const { NODE_ENV: _, ...env } = process.env;
  return promisify(execFile)(
    process.execPath,
    [vite, 'build', '--outDir', folder, '--emptyOutDir', '--logLevel', 'error'],
    {
      cwd: root,
      env,
    },
  );
}
