import { execFileSync } from 'node:child_process';
import { createRequire } from 'node:module';

const biome = createRequire(import.meta.url).resolve('@biomejs/biome/bin/biome');

/** Source as `npm run format` leaves it. */
export const formatted = (path: string, source: string): string =>
  execFileSync(process.execPath, [biome, 'check', '--write', `--stdin-file-path=${path}`], {
    input: source,
    encoding: 'utf8',
  });
