import { readdirSync, readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { sharedNames, withShortLocals } from './shortLocals.js';
import { shortNames, withShortNames, wordsIn } from './shortNames.js';

const inRoot = (path: string): string => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const FOLDER = inRoot('shaders');
/** Code that writes parts of shaders, and the parts of three.js in the versions that the library draws with. */
const BESIDE = [
  ...['src/material', 'src/look'],
  ...['three', 'three-middle', 'three-oldest'].map((version) => `node_modules/${version}/src/renderers`),
];
const IS_SHADER = /\.(glsl|vert|frag)$/;

/**
 * Shaders without comments, indentation and most spaces, and with short names for what only they know: three.js shows a program's text where
 * it fails, and ships it everywhere else.
 */
export const shortShaders: Plugin = {
  name: 'short-shaders',
  enforce: 'pre',
  apply: 'build',
  async load(id) {
    const [path, query] = id.split('?');
    if (query !== 'raw' || !IS_SHADER.test(path)) return null;
    return `export default ${JSON.stringify(asShipped(await readFile(path, 'utf8')))};`;
  },
};

/** A shader as pages get it. */
export function asShipped(text: string): string {
  names ??= allNames();
  return withShortNames(withShortLocals(shortened(text), names.shared), names.short);
}

interface Names {
  /** Names that functions may share with what lies in other files. */
  readonly shared: ReadonlySet<string>;
  readonly short: ReadonlyMap<string, string>;
}

let names: Names | undefined;

function allNames(): Names {
  const shaders = textsIn(FOLDER, IS_SHADER).map(shortened);
  const code = BESIDE.flatMap((folder) => textsIn(inRoot(folder), /\.[jt]s$/));
  return { shared: sharedNames(shaders), short: shortNames(shaders, new Set(code.flatMap(wordsIn))) };
}

const textsIn = (folder: string, kind: RegExp): string[] =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((path) => kind.test(path))
    .map((path) => readFileSync(join(folder, path), 'utf8'));

/** The same program in fewer characters. Every directive keeps its line. */
export function shortened(text: string): string {
  return (
    text
      .replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '')
      .replace(/^\s+|[ \t]+$/gm, '')
      // A parameter is an input unless it says otherwise. That it is constant saves compilers a copy.
      .replace(/\bconst in /g, 'const ')
      // Spaces stay in directives, where the space after a macro's name has a meaning.
      .replace(/^[^#].*/gm, (line) =>
        line
          .replace(/ ?([-+]=|[=*/%<>,;(){}?:&|]) ?/g, '$1')
          // Beside another + or − they stay, or `a + +b` would become `a++b`.
          .replace(/(?<![+-]) ?([+-]) ?(?![ +-])/g, '$1')
          // 0.5 and 1.0 as .5 and 1.
          .replace(/(?<![\w.])0(\.\d)/g, '$1')
          .replace(/(?<![\w.])(\d+\.)0(?![\w.])/g, '$1'),
      )
      .replace(/^#(el)?if .*/gm, (line) => line.replace(/ (==|!=|>|<|&&|\|\|) /g, '$1'))
      .replace(/(^[^#\n].*[{}(,;])\n(?!#)/gm, '$1')
      .replace(/(^[^#\n].*)\n(?=[})])/gm, '$1')
      // Users look for this text in `onBeforeCompile`.
      .replace('void main(){', 'void main() {')
  );
}
