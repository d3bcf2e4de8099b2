import { readdirSync, readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { sharedNames, withShortLocals } from './shortLocals.js';

const FOLDER = fileURLToPath(new URL('../../shaders', import.meta.url));
const IS_SHADER = /\.(glsl|vert|frag)$/;

/**
 * Shaders without comments, indentation and most spaces, and with local names of one letter: three.js shows a program's text where it fails,
 * and ships it everywhere else.
 */
export const shortShaders: Plugin = {
  name: 'short-shaders',
  enforce: 'pre',
  apply: 'build',
  async load(id) {
    const [path, query] = id.split('?');
    if (query !== 'raw' || !IS_SHADER.test(path)) return null;
    shared ??= sharedNames(allShaders());
    return `export default ${JSON.stringify(withShortLocals(shortened(await readFile(path, 'utf8')), shared))};`;
  },
};

let shared: ReadonlySet<string> | undefined;

const allShaders = (): string[] =>
  readdirSync(FOLDER, { recursive: true, encoding: 'utf8' })
    .filter((path) => IS_SHADER.test(path))
    .map((path) => shortened(readFileSync(join(FOLDER, path), 'utf8')));

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
          .replace(/ ?([=*/<>,;(){}?:&|]) ?/g, '$1')
          // Beside another + or − they stay, or `a + +b` would become `a++b`.
          .replace(/(?<![+-]) ([+-]) (?![+-])/g, '$1')
          // 0.5 and 1.0 as .5 and 1.
          .replace(/(?<![\w.])0(\.\d)/g, '$1')
          .replace(/(?<![\w.])(\d+\.)0(?![\w.])/g, '$1'),
      )
      .replace(/^#(el)?if .*/gm, (line) => line.replace(/ (==|!=|>|<|&&|\|\|) /g, '$1'))
      .replace(/(^[^#\n].*[{(,;])\n(?!#)/gm, '$1')
      .replace(/(^[^#\n].*)\n(?=[})])/gm, '$1')
      // Users look for this text in `onBeforeCompile`.
      .replace('void main(){', 'void main() {')
  );
}
