import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
/** A separate project. It finds three and the tools in the node_modules of the repository above it. */
export const projectFolder = join(root, 'tests/output/consumers');
export const libraryFolder = join(projectFolder, 'node_modules/three-hatching');
export const threeFolder = join(root, 'node_modules/three');

let installed: string[] | undefined;

/**
 * Builds the library, packs it as it would be published, and installs the tarball in a small project that holds the
 * pages beside this file. It does so once for all tests of a process.
 *
 * @returns the paths of all files in the tarball
 */
export function installPackedLibrary(): string[] {
  installed ??= install();
  return installed;
}

function install(): string[] {
  rmSync(projectFolder, { recursive: true, force: true });
  mkdirSync(libraryFolder, { recursive: true });
  const npm = (...args: string[]) =>
    execFileSync('npm', args, {
      cwd: root,
      encoding: 'utf8',
      shell: process.platform === 'win32',
      stdio: ['ignore', 'pipe', 'pipe'],
    });
  npm('run', '--silent', 'build:lib');
  const [packed] = JSON.parse(npm('pack', '--json', '--pack-destination', projectFolder)) as [
    { filename: string; files: { path: string }[] },
  ];
  execFileSync('tar', ['-xzf', packed.filename, '-C', 'node_modules/three-hatching', '--strip-components=1'], {
    cwd: projectFolder,
  });
  cpSync(join(dirname(fileURLToPath(import.meta.url)), 'pages'), projectFolder, { recursive: true });
  writeFileSync(join(projectFolder, 'package.json'), '{ "name": "consumer", "private": true, "type": "module" }\n');
  return packed.files.map(({ path }) => path).sort();
}
