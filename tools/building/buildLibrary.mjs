/** `npm run build:lib`: builds the library into dist in the passes of vite.lib.config.ts, and writes its declarations. */
import { execFileSync } from 'node:child_process';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
const configFile = join(root, 'tools/building/vite.lib.config.ts');

// The first pass empties dist.
for (const mode of ['production', 'worker', 'svgWorker', 'handWorker', 'command', 'draw', 'hands', 'react', 'element'])
  await build({ root, configFile, mode });

const tsc = join(dirname(createRequire(import.meta.url).resolve('typescript/package.json')), 'bin/tsc');
execFileSync(process.execPath, [tsc, '--project', 'tools/building/tsconfig.lib.json'], { cwd: root, stdio: 'inherit' });
