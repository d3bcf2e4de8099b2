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
    const text = (await readFile(path, 'utf8'))
      .replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '')
      .replace(/^\s+|[ \t]+$/gm, '')
      // Spaces stay in directives, where the space after a macro's name has a meaning, and beside + and −, or `a + +b` would become `a++b`.
      .replace(/^[^#].*/gm, (line) => line.replace(/ ?([=*/<>,;(){}?:&|]) ?/g, '$1'));
    return `export default ${JSON.stringify(text)};`;
  },
};
