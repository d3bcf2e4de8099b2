import { describe, expect, it } from 'vitest';
import { readRanges, writeRanges } from '../../../../src/viewer/settings/ranges.js';

describe('ranges of indices', () => {
  it.each([
    [[], ''],
    [[0], '1'],
    [[0, 1, 2, 6], '1-3,7'],
    [[4, 5], '5-6'],
  ])('writes %j as "%s", and reads it', (indices, text) => {
    expect(writeRanges(indices)).toBe(text);
    expect(readRanges(text)).toEqual(indices);
  });

  it('keeps all but one of 5,000 parts short', () => {
    const all = Array.from({ length: 5000 }, (_, i) => i).filter((i) => i !== 2316);
    expect(writeRanges(all)).toBe('1-2316,2318-5000');
    expect(readRanges(writeRanges(all))).toEqual(all);
  });

  it.each(['0', '-3', 'a-b', '3-', '7-2', '1e3', '1-9999999'])('ignores "%s"', (text) => {
    expect(readRanges(text)).toEqual([]);
  });

  it('sorts, and takes each once', () => {
    expect(readRanges('7,1-3,2,x')).toEqual([0, 1, 2, 6]);
  });

  it('reads no more than a file can have', () => {
    expect(readRanges(Array.from({ length: 9 }, () => '1-999999').join(','))).toHaveLength(100_000);
  });
});
