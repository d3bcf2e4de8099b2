import { execFile } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const run = promisify(execFile);
const root = fileURLToPath(new URL('../..', import.meta.url));
/** Within the project, so that it finds three. */
const outDir = join(root, 'tests/output/drawCommand');

/** Builds the command, and what it needs of the library. Each pass has a process of its own, as a build sets NODE_ENV. */
export async function buildCommand(): Promise<void> {
  const vite = join(dirname(fileURLToPath(import.meta.resolve('vite/package.json'))), 'bin/vite.js');
  const config = ['--config', join(root, 'tools/building/vite.lib.config.ts'), '--outDir', outDir];
  const build = (mode: string) =>
    run(process.execPath, [vite, 'build', ...config, '--mode', mode, '--logLevel', 'error'], { cwd: root });
  // The first empties the folder.
  await build('production');
  await Promise.all(['command', 'draw'].map(build));
}

/** Runs `npx three-hatching draw` with arguments. Rejects unless all is drawn. */
export async function drawByCommand(...args: string[]): Promise<void> {
  await run(process.execPath, [join(outDir, 'command.js'), 'draw', ...args]);
}
