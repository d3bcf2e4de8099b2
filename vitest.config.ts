import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig } from 'vitest/config';
import { formSources } from './tools/building/formSources.js';
import { libraryEntries } from './tools/building/libraryEntries.js';
import { occlusionAhead } from './tools/building/occlusionAhead.js';

const files = ['unit', 'reference'].flatMap((folder) =>
  readdirSync(join('tests', folder), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.test.ts'))
    .map((name) => join('tests', folder, name)),
);
/** Files that replace modules or globals, count what code allocates, or depend on what was warned of or loaded before. */
const alone = files.filter(
  (path) =>
    /(garbage|HatchingBackground|workPerFrame)\.test\.ts$/.test(path) ||
    /\bvi\.(mock|doMock|resetModules|stubGlobal)\(/.test(readFileSync(path, 'utf8')),
);

/** Tests that need no browser: pure code, and the double-precision reference. */
export default defineConfig({
  plugins: [formSources, occlusionAhead],
  resolve: { alias: libraryEntries('./src/', 'ts', 'development') },
  test: {
    environment: 'node',
    // Property tests and whole map generations on a busy machine; what must be fast is shown by counting steps.
    testTimeout: 300_000,
    hookTimeout: 300_000,
    tags: [
      { name: 'all', description: 'A test that `npm test` leaves out.' },
      { name: 'more', description: 'A test that tries fewer cases in `npm test`.' },
    ],
    // Two cores: a third process only takes time from the others.
    maxWorkers: 2,
    projects: [
      // These files share a process, which loads once what they import.
      {
        extends: true,
        test: {
          name: 'together',
          include: files,
          exclude: alone,
          isolate: false,
          setupFiles: 'tests/unit/loadParts.ts',
        },
      },
      { extends: true, test: { name: 'alone', include: alone, sequence: { groupOrder: 1 } } },
    ],
  },
});
