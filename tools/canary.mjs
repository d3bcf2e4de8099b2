/**
 * `npm run canary`: installs the newest published three.js into a temporary folder, and runs the tests of what three.js does not promise
 * with it too. `npm run canary -- 0.186.0` takes another version. Ends with 1 if a test fails.
 */
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const wanted = process.argv[2] ?? 'latest';
const isWindows = process.platform === 'win32';
const folder = mkdtempSync(join(tmpdir(), 'three-canary-'));
try {
  writeFileSync(join(folder, 'package.json'), '{ "private": true }');
  const install = ['install', '--no-audit', '--no-fund', '--ignore-scripts', `three@${wanted}`];
  execFileSync(isWindows ? 'npm.cmd' : 'npm', install, { cwd: folder, stdio: 'inherit', shell: isWindows });
  const three = join(folder, 'node_modules/three');
  const { version } = JSON.parse(readFileSync(join(three, 'package.json'), 'utf8'));
  console.log(`three.js ${version}, of ${wanted}`);
  const vitest = join(root, 'node_modules/vitest/vitest.mjs');
  const { status } = spawnSync(process.execPath, [vitest, 'run', 'tests/unit/material/three'], {
    cwd: root,
    stdio: 'inherit',
    env: { ...process.env, HATCH_CANARY: three },
  });
  process.exitCode = status ?? 1;
} finally {
  rmSync(folder, { recursive: true, force: true });
}
