import { readFileSync } from 'node:fs';

/**
 * Width and height of docs/three-lines.png.
 *
 * @type {readonly [width: number, height: number]}
 */
export const THREE_LINES_SIZE = [840, 560];

/** @returns {string} the code of the README beside docs/three-lines.png */
export function readmeLines() {
  const found = /three-lines\.png\)\s+```ts\n([\s\S]*?)```/.exec(readFileSync('README.md', 'utf8'));
  if (!found) throw new Error('readmeLines: README.md has no code below docs/three-lines.png.');
  return found[1];
}
