/**
 * `npm run test:busy`: `npm test` and then `npm run test:rest`, beside an endless loop on every core. What passes on a quiet machine and fails here
 * depends on time.
 */
import { spawn, spawnSync } from 'node:child_process';
import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';

const run = fileURLToPath(new URL('run.mjs', import.meta.url));
const loops = Array.from({ length: availableParallelism() }, () =>
  spawn(process.execPath, ['-e', 'for (;;);'], { stdio: 'ignore' }),
);
const stop = () => {
  for (const loop of loops) loop.kill('SIGKILL');
};
process.on('exit', stop);
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => process.exit(1));

const words = process.argv.slice(2);
const codes = ['quick', 'rest'].map(
  (selection) => spawnSync(process.execPath, [run, selection, ...words], { stdio: 'inherit' }).status,
);
process.exit(codes.every((code) => code === 0) ? 0 : 1);
