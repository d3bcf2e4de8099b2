import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

const require = createRequire(import.meta.url);
const program = (name, file) => join(dirname(require.resolve(`${name}/package.json`)), file);

/** The command line programs that run tests, for the Node of whoever starts them. */
export const VITEST = program('vitest', 'vitest.mjs');
export const PLAYWRIGHT = program('@playwright/test', 'cli.js');
