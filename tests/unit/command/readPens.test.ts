import { describe, expect, test } from 'vitest';
import { metresOf, penLayers, penWidths } from '../../../src/command/readPens.js';

describe('widths of pens', () => {
  test.each([
    ['0.3', 0.3],
    ['.25mm', 0.25],
    ['outlines 0.5', { outlines: 0.5 }],
    ['0.2, outlines 0.5,HIDDEN 0.1', { outlines: 0.5, hidden: 0.1, lines: 0.2, background: 0.2, dots: 0.2 }],
  ])('%s', (text, widths) => expect(penWidths(text)).toEqual(widths));

  test.each(['', '0', '30', 'thick', '0.3 0.4', 'outlines', 'edges 0.5', '0.3,', '0.3, outlines 0'])(
    '%j is refused in a sentence',
    (text) => expect(() => penWidths(text)).toThrow(/^--pen is .*, but must be .*\.$/),
  );
});

describe('layers of pens', () => {
  test.each(['layer', 'ink', 'material', 'part'])('%s, also after the word by', (word) => {
    expect(penLayers(word)).toBe(word);
    expect(penLayers(`by ${word.toUpperCase()}`)).toBe(word);
  });

  test('colours with widths and speeds', () => {
    expect(penLayers('black 0.3, #D33, red 0.5 +S40')).toEqual([
      { color: 'black', name: 'black', width: 0.3, speed: undefined },
      { color: '#d33', name: '#D33', width: undefined, speed: undefined },
      { color: 'red', name: 'red', width: 0.5, speed: 40 },
    ]);
  });

  test.each(['', '2', 'black 0.3 0.4', 'black, ', 'black +S0', 'black +S140', '#12', 'red thick'])(
    '%j is refused in a sentence',
    (text) => expect(() => penLayers(text)).toThrow(/^--pens is .*, but must be .*\.$/),
  );
});

test('metres', () => {
  expect([metresOf('refill', '40m'), metresOf('refill', '2.5 m'), metresOf('refill', '7')]).toEqual([40, 2.5, 7]);
  for (const text of ['', '0', '-1m', '4km'])
    expect(() => metresOf('refill', text)).toThrow(
      `--refill is ${/^\S+$/.test(text) ? text : `"${text}"`}, but must be a number of metres above 0`,
    );
});
