import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

/** Tests that need no browser: pure code, and the double-precision reference. */
export default defineConfig({
  resolve: { alias: { 'three-hatching': fileURLToPath(new URL('./src/index.ts', import.meta.url)) } },
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
