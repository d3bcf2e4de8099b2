import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));

/**
 * All examples, read from their folders, for what runs outside of Vite; pages import `examples.ts`.
 *
 * @returns {import('./examples.js').Example[]}
 */
export const readExamples = () =>
  readdirSync(here)
    .filter((folder) => existsSync(`${here}${folder}/example.json`))
    .map((folder) => ({ ...JSON.parse(readFileSync(`${here}${folder}/example.json`, 'utf8')), folder }))
    .sort((a, b) => a.order - b.order);
