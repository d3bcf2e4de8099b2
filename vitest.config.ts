import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { formSources } from './building/formSources.js';

/** Tests that need no browser: pure code, and the double-precision reference. */
export default defineConfig({
  plugins: [formSources],
  resolve: {
    alias: {
      'three-hatching/react': fileURLToPath(new URL('./src/react/index.ts', import.meta.url)),
      'three-hatching': fileURLToPath(new URL('./src/index.ts', import.meta.url)),
    },
  },
  test: {
    environment: 'node',
    include: ['tests/unit/**/*.test.ts', 'tests/reference/**/*.test.ts'],
    // Property tests and whole map generations on a busy machine; what must be fast is shown by counting steps.
    testTimeout: 60_000,
    hookTimeout: 60_000,
    // Two cores: a third process only takes time from the others.
    maxWorkers: 2,
  },
});
