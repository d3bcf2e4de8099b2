import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { beforeAll, expect, test } from 'vitest';
import { root } from './docs/documents.js';

const folder = join(root, 'tests/output/declarations');
const ENTRIES = [
  'index',
  'facts',
  'vector/svg/index',
  'webgpu/index',
  'react/index',
  'element/element',
  'element/react',
  'element/preact',
  'element/vue',
];

/** A declaration at the top of a file, without comments. What is private in it has no type. */
interface Declaration {
  text: string;
  /** The types that its file knows, imported ones and its own, and the file that declares each. */
  known: ReadonlyMap<string, string>;
}

beforeAll(() => {
  rmSync(folder, { recursive: true, force: true });
  const tsc = join(dirname(createRequire(import.meta.url).resolve('typescript/package.json')), 'bin/tsc');
  execFileSync(process.execPath, [tsc, '--project', 'tools/building/tsconfig.lib.json', '--outDir', folder], {
    cwd: root,
  });
});

test.each(ENTRIES)('every type in a signature of %s is exported from there, or from the main entry', (entry) => {
  // Types of the main entry need no second place.
  const exported = new Map([...exportsOf('index'), ...exportsOf(entry)]);
  const lacking = new Set<string>();
  for (const [name, file] of exportsOf(entry)) {
    const { text, known } = declarationOf(name, file);
    for (const [used, from] of known) {
      if (used === name || exported.get(used) === from || !new RegExp(`\\b${used}\\b`).test(text)) continue;
      lacking.add(`${used} of ${name}`);
    }
  }
  expect([...lacking]).toEqual([]);
});

const textOf = (file: string): string =>
  readFileSync(join(folder, `${file}.d.ts`), 'utf8').replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '');

/** The file, without its ending, that an import in another one means. */
const resolved = (from: string, file: string): string => join(dirname(file), from).replace(/\.js$/, '');

const namesIn = (list: string): string[] =>
  list
    .split(',')
    .map((name) => name.replace(/^\s*type\s+/, '').trim())
    .filter(Boolean);

/** Every name that a file exports, and the file that declares it. */
function exportsOf(file: string): Map<string, string> {
  const text = textOf(file);
  const found = new Map<string, string>();
  for (const [, list, from] of text.matchAll(/^export (?:type )?\{([^}]*)\} from '(\.[^']*)'/gm))
    for (const name of namesIn(list)) found.set(name, exportsOf(resolved(from, file)).get(name)!);
  for (const [, from] of text.matchAll(/^export (?:type )?\* from '(\.[^']*)'/gm))
    for (const [name, path] of exportsOf(resolved(from, file))) found.set(name, path);
  for (const [, name] of text.matchAll(DECLARED)) found.set(name, file);
  for (const [, list] of text.matchAll(/^export (?:type )?\{([^}]*)\};/gm))
    for (const name of namesIn(list)) found.set(name, imported(text, file).get(name) ?? file);
  return found;
}

const DECLARED = /^(?:export )?(?:declare )?(?:abstract )?(?:class|interface|type|function|const) (\w+)/gm;

/** What a file imports from others of the library, and the file that declares it. */
function imported(text: string, file: string): Map<string, string> {
  return new Map(
    [...text.matchAll(/^import (?:type )?\{([^}]*)\} from '(\.[^']*)'/gm)].flatMap(([, list, from]) =>
      namesIn(list).map((name) => [name, exportsOf(resolved(from, file)).get(name)!] as const),
    ),
  );
}

function declarationOf(name: string, file: string): Declaration {
  const text = textOf(file);
  const own = [...text.matchAll(DECLARED)];
  const types = own.filter(([start]) => !/\b(?:const|function) /.test(start));
  const known = new Map([...types.map(([, other]) => [other, file] as const), ...imported(text, file)]);
  const parts = own.flatMap((match, i) => (match[1] === name ? [text.slice(match.index, own[i + 1]?.index)] : []));
  return { text: parts.join('\n'), known };
}
