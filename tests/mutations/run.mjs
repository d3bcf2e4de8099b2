/**
 * `npm run mutations`: breaks the source in each way of the table, and shows that a test notices. `npm run mutations -- files undo` takes only
 * breaks whose area, name or file contains one of the words.
 *
 * A break counts as caught where the test that the table names fails with it. That test is first looked for in `npm test`. Ends with one line,
 * `N of M breaks caught, K of them by npm test alone`, and with 1 where one is not caught.
 */
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';
import { runCatcher, stopCatcher } from './runCatcher.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** The original text of the broken file. */
let whole;
const mend = () => {
  if (whole) writeFileSync(whole.path, whole.text);
  whole = undefined;
};
process.on('exit', mend);
for (const [signal, code] of [
  ['SIGINT', 130],
  ['SIGTERM', 143],
  ['SIGHUP', 129],
]) {
  process.on(signal, () => {
    stopCatcher();
    process.exit(code);
  });
}

const words = process.argv.slice(2).map((word) => word.toLowerCase());
const breaks = Object.entries(await readTable())
  .flatMap(([area, mutations]) => mutations.map((mutation) => ({ area, ...mutation })))
  .filter(({ area, name, file }) => {
    const text = `${area} ${name} ${file}`.toLowerCase();
    return words.length === 0 || words.some((word) => text.includes(word));
  });

const changed = changedFiles(new Set(breaks.map(({ file }) => file)));
if (breaks.length === 0) {
  console.error(`npm run mutations: no break in the table with ${words.join(' or ')}.`);
  process.exitCode = 1;
} else if (changed !== '') {
  console.error(`npm run mutations: commit or undo these changes first, since the files will be broken:\n${changed}`);
  process.exitCode = 1;
} else {
  await tryAll();
}

async function tryAll() {
  let caught = 0;
  let quick = 0;
  for (const mutation of breaks) {
    const begin = performance.now();
    const { selection, complaint } = await tryBreak(mutation);
    if (selection) caught += 1;
    if (selection === 'quick') quick += 1;
    const verdict = selection ? 'caught' : 'MISSED';
    const remark = selection === 'all' ? ', only test:all' : '';
    const seconds = ((performance.now() - begin) / 1000).toFixed(0);
    console.log(`${verdict}  ${mutation.area}: ${mutation.name} (${mutation.caughtBy.layer}, ${seconds} s${remark})`);
    if (complaint) console.log(complaint.replace(/^/gm, '        '));
  }
  console.log(`${caught} of ${breaks.length} breaks caught, ${quick} of them by npm test alone`);
  if (caught < breaks.length) process.exitCode = 1;
}

/** The selection of tests that catches the break, if any. */
async function tryBreak({ file, find, replace, caughtBy }) {
  const path = `${root}${file}`;
  const text = readFileSync(path, 'utf8');
  if (text.split(find).length !== 2) return { complaint: `${file} does not hold what is to be replaced once.` };
  whole = { path, text };
  writeFileSync(
    path,
    text.replace(find, () => replace),
  );
  try {
    let passed = 0;
    for (const selection of ['quick', 'all']) {
      const { tried, failed, complaint } = await runCatcher(caughtBy, selection);
      if (failed > 0) return { selection };
      if (complaint) return { complaint };
      // The same test tries more cases where all are tried.
      passed = Math.max(passed, tried);
    }
    const where = `${caughtBy.file}: ${caughtBy.title ?? 'all tests'}`;
    return { complaint: passed > 0 ? `${passed} passed in ${where}` : `There is no such test in ${where}` };
  } finally {
    mend();
  }
}

async function readTable() {
  const server = await createServer({
    root,
    logLevel: 'error',
    server: { middlewareMode: true, ws: false, watch: null },
  });
  const { table } = await server.ssrLoadModule('/tests/mutations/table/index.ts');
  await server.close();
  return table;
}

/** The uncommitted changes of these files, as git tells them. */
function changedFiles(files) {
  if (files.size === 0) return '';
  return execFileSync('git', ['status', '--porcelain', '--', ...files], { cwd: root, encoding: 'utf8' }).trimEnd();
}
