import { describe, expect, test } from 'vitest';
import { distinctNames, indexOfName } from '../../../../../src/viewer/files/common/ModelError.js';

test('things of one name, or of none, have names that differ', () => {
  expect(distinctNames(['Up', undefined, 'Up', '', 'Down', 'Up'], 'Clip')).toEqual([
    ...['Up', 'Clip 2', 'Up 2', 'Clip 4', 'Down', 'Up 3'],
  ]);
});

describe('a thing is chosen by its name or its number', () => {
  test.each([
    ['Front', 0],
    ['front', 1],
    ['FRONT', 0],
    ['side view', 2],
    ['1', 3],
    ['2', 1],
    ['4', 3],
    ['5', -1],
    ['0', -1],
    ['1.5', -1],
    ['', -1],
    ['fro', -1],
  ])('%j', (wanted, index) => {
    expect(indexOfName(['Front', 'front', ' Side View', '1'], wanted)).toBe(index);
  });
});
