/** `npm run support`: measures every feature with every technique, and writes the table in docs/support.md. */
import { spawnSync } from 'node:child_process';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

const playwright = join(dirname(createRequire(import.meta.url).resolve('@playwright/test/package.json')), 'cli.js');
const { status } = spawnSync(process.execPath, [playwright, 'test', '--project=gpu', 'besideLambert'], {
  stdio: 'inherit',
  env: { ...process.env, UPDATE_SUPPORT: '1' },
});
process.exitCode = status ?? 1;
