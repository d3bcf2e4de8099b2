import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { vi } from 'vitest';
import { Random } from '../../../../src/viewer/settings/Random.js';

/** 300 in `npm test`; `npm run fuzz` asks for more, and may begin elsewhere. */
const CASES = Number(process.env.FUZZ_CASES ?? 300);
const FIRST = Number(process.env.FUZZ_FIRST ?? 1);

/** Much more than any number of cases takes. */
export const FUZZ_TIMEOUT = 24 * 3600 * 1000;

/** Counts by kind of case, as they stand in tests/output/fuzz. */
export type FuzzReport = Record<
  string,
  { cases: number; good: number; refused: number; slowest: { seed: number; milliseconds: number } }
>;

/** The seeds of one of several kinds. */
export const seedsOf = (kind: number, kinds: number): number[] =>
  Array.from({ length: CASES }, (_, i) => FIRST + i).filter((seed) => seed % kinds === kind);

/**
 * Runs the cases of a kind.
 *
 * @param run says how one ended; throws if that is not right
 * @returns what went wrong, with the seeds
 */
export async function runCases(
  report: FuzzReport,
  kind: string,
  seeds: readonly number[],
  run: (random: Random) => Promise<'good' | 'refused'>,
): Promise<string[]> {
  const sums = { cases: 0, good: 0, refused: 0, slowest: { seed: 0, milliseconds: 0 } };
  report[kind] = sums;
  const failures: string[] = [];
  for (const seed of seeds) {
    const start = performance.now();
    try {
      sums[await run(new Random(seed))]++;
    } catch (error) {
      failures.push(`seed ${seed}: ${error instanceof Error ? error.stack?.slice(0, 500) : error}`);
    }
    const milliseconds = Math.round(performance.now() - start);
    sums.cases++;
    if (milliseconds > sums.slowest.milliseconds) sums.slowest = { seed, milliseconds };
  }
  return failures;
}

/** What is said on the console while `run` runs. It is not shown. */
export async function consoleDuring<Result>(run: () => Promise<Result>): Promise<{ result: Result; said: string[] }> {
  const said: string[] = [];
  const spies = (['warn', 'error'] as const).map((method) =>
    vi.spyOn(console, method).mockImplementation((...words) => void said.push(words.join(' '))),
  );
  try {
    return { result: await run(), said };
  } finally {
    for (const spy of spies) spy.mockRestore();
  }
}

/** Writes counts into tests/output, for `npm run fuzz`. */
export function writeReport(name: string, report: FuzzReport): void {
  const folder = fileURLToPath(new URL('../../../output/fuzz/', import.meta.url));
  mkdirSync(folder, { recursive: true });
  writeFileSync(`${folder}${name}.json`, `${JSON.stringify(report, undefined, 2)}\n`);
}
