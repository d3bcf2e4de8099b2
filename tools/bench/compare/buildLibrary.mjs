import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const run = (cwd, command, ...args) => execFileSync(command, args, { cwd, stdio: ['ignore', 'ignore', 'inherit'] });

/** Paths of the configuration that builds the library. Older commits have it in their root. */
const CONFIGS = ['tools/building/vite.lib.config.ts', 'vite.lib.config.ts'];

/**
 * Builds the library of a commit, or of the working tree if there is none, by that commit's own configuration.
 *
 * @param {string | undefined} commit
 * @param {string} outDir
 */
export function buildLibrary(commit, outDir) {
  if (commit === undefined) {
    build(root, outDir);
    return;
  }
  const folder = mkdtempSync(join(tmpdir(), 'hatching-compare-'));
  try {
    run(root, 'git', 'worktree', 'add', '--detach', '--quiet', folder, commit);
    install(folder);
    build(folder, outDir);
  } finally {
    // The link is removed first, so that git cannot follow it and delete our packages.
    rmSync(join(folder, 'node_modules'), { recursive: true, force: true });
    run(root, 'git', 'worktree', 'remove', '--force', folder);
  }
}

/** Gives the commit its packages: a link to ours if they are the same, else an installation. */
function install(folder) {
  if (packagesOf(folder) === packagesOf(root))
    symlinkSync(join(root, 'node_modules'), join(folder, 'node_modules'), 'junction');
  else run(folder, 'npm', 'ci', '--no-audit', '--no-fund');
}

/** The packages that a lockfile installs, as text: all that it names but the project itself. */
function packagesOf(folder) {
  const { packages } = JSON.parse(readFileSync(join(folder, 'package-lock.json'), 'utf8'));
  return JSON.stringify({ ...packages, '': undefined });
}

function build(folder, outDir) {
  const vite = join(folder, 'node_modules/vite/bin/vite.js');
  const config = CONFIGS.find((path) => existsSync(join(folder, path)));
  const flags = ['--config', config, '--outDir', outDir, '--emptyOutDir', '--logLevel', 'error'];
  run(folder, process.execPath, vite, 'build', ...flags);
}
