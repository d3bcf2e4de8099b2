import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { FAR_SLOWER, guardFigure } from '../../../../tools/bench/compare/guardFigure.mjs';
import { hasCommit } from '../../../../tools/bench/compare/hasCommit.mjs';

type Interval = [median: number, low: number, high: number];

/** Guards a figure that gives these intervals in turn, and counts its runs. */
async function guard(...intervals: Interval[]) {
  let runs = 0;
  const { verdict } = await guardFigure(async () => intervals[runs++]!);
  return { verdict, runs };
}

const far: Interval = [1.5, FAR_SLOWER + 0.01, 1.7];

test.each<[string, Interval[], string, number]>([
  ['as fast as it was', [[1, 0.98, 1.02]], 'same', 1],
  ['faster', [[0.8, 0.7, 0.9]], 'faster', 1],
  ['slower, but not by far', [[1.4, FAR_SLOWER, 1.6]], 'slower', 1],
  ['far slower, by chance', [far, [1.01, 0.9, 1.1]], 'same', 2],
  ['far slower, then slower', [far, [1.2, 1.1, 1.4]], 'slower', 2],
  ['far slower twice', [far, far], 'far slower', 2],
])('a figure that is %s', async (_, intervals, verdict, runs) => {
  expect(await guard(...intervals)).toEqual({ verdict, runs });
});

test('a commit is found in a history that has it, and not in another, nor where there is none', () => {
  const folder = mkdtempSync(join(tmpdir(), 'hatching-guard-'));
  const git = (...words: string[]): string =>
    execFileSync('git', ['-c', 'user.name=test', '-c', 'user.email=test@example.org', ...words], {
      cwd: folder,
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    }).trim();
  try {
    // No history reaches from above into the folder.
    writeFileSync(join(folder, '.git'), 'gitdir: nowhere\n');
    expect(hasCommit('HEAD', folder)).toBe(false);
    rmSync(join(folder, '.git'));
    git('init', '--quiet');
    git('commit', '--quiet', '--allow-empty', '--message', 'first');
    expect(hasCommit(git('rev-parse', 'HEAD'), folder)).toBe(true);
    expect(hasCommit('0123456789abcdef0123456789abcdef01234567', folder)).toBe(false);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

test('the file names one commit, whole', () => {
  const named = readFileSync(new URL('../../../../tools/bench/guardedCommit.txt', import.meta.url), 'utf8');
  expect(named).toMatch(/^[0-9a-f]{40}\n$/);
});
