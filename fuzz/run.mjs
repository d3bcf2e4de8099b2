/**
 * `npm run fuzz`: 10,000 damaged files and calls, from seeds. `npm run fuzz -- 50000 20001` tries as many as are asked for, from that seed
 * on. What goes wrong is listed with its seed; the counts are left in tests/output/fuzz.
 */
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const [cases = '10000', first = '1'] = process.argv.slice(2);
if (!(Number(cases) > 0) || !(Number(first) >= 0)) {
  throw new Error('fuzz/run.mjs: expected a number of cases and the first seed, as in "npm run fuzz -- 50000 20001".');
}
const { status } = spawnSync('npx', ['vitest', 'run', 'tests/unit/fuzz'], {
  cwd: root,
  stdio: 'inherit',
  env: { ...process.env, FUZZ_CASES: cases, FUZZ_FIRST: first },
});
const report = ['files', 'library'].map((name) =>
  JSON.parse(readFileSync(`${root}/tests/output/fuzz/${name}.json`, 'utf8')),
);
console.table(
  Object.fromEntries(
    Object.entries(Object.assign({}, ...report)).map(([kind, { slowest, ...sums }]) => [
      kind,
      { ...sums, 'slowest, ms': slowest.milliseconds, 'its seed': slowest.seed },
    ]),
  ),
);
process.exitCode = status ?? 1;
