import { expect, test } from 'vitest';
import { shortNotes } from '../../../../src/playground/loading/ModelCaption.js';

const LONG = 'a note of fifty letters, or so, which takes a line…';

test('the caption shows as many notes as fit, and counts the others', () => {
  expect(shortNotes([])).toBe('');
  expect(shortNotes(['one', 'two', 'three'])).toBe('one; two; three');
  expect(shortNotes([LONG, 'two', LONG, 'four'])).toBe(`${LONG}; two; 2 more behind “i”`);
  expect(shortNotes([LONG.repeat(4), 'two'])).toBe(`${LONG.repeat(4)}; 1 more behind “i”`);
});
