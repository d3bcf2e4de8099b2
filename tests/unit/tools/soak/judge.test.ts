import { describe, expect, test } from 'vitest';
import { grown, judge } from '../../../../tools/soak/judge.js';

const laps = (...textures: number[]) => textures.map((texture) => ({ texture, heap: 20 }));

describe('the soak', () => {
  test('finds what grows, also by one in each of many laps', () => {
    expect(judge(laps(9, 12, 13, 14, 19, 20))).toEqual(['texture grows: 13 at first, 20 later.']);
    expect(judge(Array.from({ length: 20 }, (_, lap) => ({ texture: 9 + lap })))).toHaveLength(1);
    expect(judge([20, 30, 40, 50, 60, 70].map((heap) => ({ texture: 9, heap })))).toHaveLength(1);
  });

  test('minds neither a cache that fills up nor a single high lap', () => {
    expect(judge(laps(3, 9, 12, 12, 12, 12))).toEqual([]);
    expect(judge(laps(9, 9, 9, 9, 9, 9, 9, 40))).toEqual([]);
    expect(judge(laps(9, 9, 9, 12, 12, 12))).toEqual([]);
  });

  test('compares before and after', () => {
    expect(grown({ texture: 9, worker: 1 }, { texture: 12, worker: 2 })).toEqual([]);
    expect(grown({ texture: 9, worker: 1 }, { texture: 14, worker: 3 })).toEqual([
      'texture grows: 9 before, 14 after.',
      'worker grows: 1 before, 3 after.',
    ]);
    expect(grown({ heap: 9 }, { heap: Number.NaN })).toHaveLength(1);
  });

  test('says when it was too short, and when something was not counted', () => {
    expect(judge(laps(9, 9, 9, 9))[0]).toMatch(/too few to tell/);
    expect(judge(laps(9, 9, 9, 9, Number.NaN))[0]).toMatch(/could not be counted/);
  });
});
