import { afterAll, describe, expect, test } from 'vitest';
import { goodDrop, KINDS } from '../../../../tools/fuzz/goodFiles.js';
import { mutate } from '../../../../tools/fuzz/mutate.js';
import { outcomeOf } from '../../../../tools/fuzz/outcomeOf.js';
import { consoleDuring, FUZZ_TIMEOUT, type FuzzReport, runCases, seedsOf, writeReport } from './report.js';

const report: FuzzReport = {};

describe('damaged files give a model or one sentence', () => {
  for (const [k, kind] of KINDS.entries()) {
    const seeds = seedsOf(k, KINDS.length);
    test(
      `${kind}: ${seeds.length} cases`,
      async () => {
        const failures = await runCases(report, kind, seeds, async (random) => {
          const files = mutate(await goodDrop(kind, random), random);
          const { result, said } = await consoleDuring(() => outcomeOf(files));
          if (said.length > 0) throw new Error(`On the console: ${said[0]}`);
          return result.kind === 'model' ? 'good' : 'refused';
        });
        expect(failures.slice(0, 20)).toEqual([]);
      },
      FUZZ_TIMEOUT,
    );
  }
  afterAll(() => writeReport('files', report));
});
