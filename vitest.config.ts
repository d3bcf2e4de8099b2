import { defineConfig } from 'vitest/config';
import { formSources } from './tools/building/formSources.js';
import { libraryEntries } from './tools/building/libraryEntries.js';
import { occlusionAhead } from './tools/building/occlusionAhead.js';

/** Tests that need no browser: pure code, and the double-precision reference. */
export default defineConfig({
  plugins: [formSources, occlusionAhead],
  resolve: { alias: libraryEntries('./src/', 'ts') },
  test: {
    environment: 'node',
    include: ['tests/unit/**/*.test.ts', 'tests/reference/**/*.test.ts'],
    // Property tests and whole map generations on a busy machine; what must be fast is shown by counting steps.
    testTimeout: 300_000,
    hookTimeout: 300_000,
    tags: [
      { name: 'all', description: 'A test that `npm test` leaves out.' },
      { name: 'more', description: 'A test that tries fewer cases in `npm test`.' },
    ],
    // Two cores: a third process only takes time from the others.
    maxWorkers: 2,
  },
});
