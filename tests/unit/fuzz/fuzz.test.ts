import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, test, vi } from 'vitest';
import { goodDrop, KINDS } from './goodFiles.js';
import { mutate } from './mutate.js';
import { outcomeOf } from './outcomeOf.js';
import { Random } from './Random.js';

/** 300 in `npm test`; `npm run fuzz` asks for more, and may begin elsewhere. */
const CASES = Number(process.env.FUZZ_CASES ?? 300);
const FIRST = Number(process.env.FUZZ_FIRST ?? 1);

interface Sums {
  cases: number;
  models: number;
  refused: number;
  withNotes: number;
  slowest: { seed: number; milliseconds: number };
}

const report: Record<string, Sums> = {};

describe('damaged files give a model or one sentence', () => {
  for (const [k, kind] of KINDS.entries()) {
    const seeds = Array.from({ length: CASES }, (_, i) => FIRST + i).filter((seed) => seed % KINDS.length === k);
    test(
      `${kind}: ${seeds.length} cases`,
      async () => {
        const sums: Sums = { cases: 0, models: 0, refused: 0, withNotes: 0, slowest: { seed: 0, milliseconds: 0 } };
        report[kind] = sums;
        const failures: string[] = [];
        for (const seed of seeds) {
          const consoleSays: string[] = [];
          for (const method of ['warn', 'error'] as const) {
            vi.spyOn(console, method).mockImplementation((...words) => void consoleSays.push(words.join(' ')));
          }
          const random = new Random(seed);
          const files = mutate(await goodDrop(kind, random), random);
          const start = performance.now();
          try {
            const outcome = await outcomeOf(files);
            if (outcome.kind === 'refused') sums.refused++;
            else sums.models++;
            if (outcome.kind === 'model' && outcome.notes.length > 0) sums.withNotes++;
            if (consoleSays.length > 0) throw new Error(`On the console: ${consoleSays[0]}`);
          } catch (error) {
            failures.push(`seed ${seed}: ${error instanceof Error ? error.stack?.slice(0, 500) : error}`);
          }
          const milliseconds = Math.round(performance.now() - start);
          sums.cases++;
          if (milliseconds > sums.slowest.milliseconds) sums.slowest = { seed, milliseconds };
          vi.restoreAllMocks();
        }
        expect(failures.slice(0, 20)).toEqual([]);
      },
      // Much more than any number of cases takes.
      24 * 3600 * 1000,
    );
  }

  afterAll(() => {
    const folder = new URL('../../output/', import.meta.url);
    mkdirSync(fileURLToPath(folder), { recursive: true });
    writeFileSync(new URL('fuzz.json', folder), `${JSON.stringify(report, undefined, 2)}\n`);
  });
});
