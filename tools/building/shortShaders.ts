import { readFile } from 'node:fs/promises';
import type { Plugin } from 'vite';

/** Shaders without comments, indentation and most spaces: three.js shows a program's text where it fails, and ships it everywhere else. */
export const shortShaders: Plugin = {
  name: 'short-shaders',
  enforce: 'pre',
  apply: 'build',
  async load(id) {
    const [path, query] = id.split('?');
    if (query !== 'raw' || !/\.(glsl|vert|frag)$/.test(path)) return null;
    return `export default ${JSON.stringify(shortened(await readFile(path, 'utf8')))};`;
  },
};

/** The same program in fewer characters. Statements keep their lines, so that a compiler's message still finds them. */
export function shortened(text: string): string {
  return (
    text
      .replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '')
      .replace(/^\s+|[ \t]+$/gm, '')
      // A parameter is an input unless it says otherwise.
      .replace(/\bconst in /g, '')
      // Spaces stay in directives, where the space after a macro's name has a meaning.
      .replace(/^[^#].*/gm, (line) =>
        line
          .replace(/ ?([=*/<>,;(){}?:&|]) ?/g, '$1')
          // Beside another + or − they stay, or `a + +b` would become `a++b`.
          .replace(/(?<![+-]) ([+-]) (?![+-])/g, '$1'),
      )
      .replace(/^#(el)?if .*/gm, (line) => line.replace(/ (==|!=|>|<|&&|\|\|) /g, '$1'))
      .replace(/(^[^#\n].*[{(,])\n(?!#)/gm, '$1')
      .replace(/(^[^#\n].*)\n(?=[})])/gm, '$1')
  );
}
