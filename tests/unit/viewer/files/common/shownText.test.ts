import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { shownName, shownText } from '../../../../../src/viewer/files/common/ModelError.js';

/** Every character that changes the order of others, or that nobody sees. */
const HIDDEN = [
  ...'\u0000\u0007\u001b\u007f\u0085\u00ad\u034f\u061c\u115f\u180e\u200b\u200c\u200d\u200e\u200f\u2028\u2029',
  ...'\u202a\u202b\u202c\u202d\u202e\u2060\u2066\u2067\u2068\u2069\u206a\u2800\u3164\ufe0f\ufeff\uffa0\u{e0041}\u{e0100}',
  '\ud800',
  '\udc00',
];

const hostileName = fc
  .array(
    fc.oneof(
      fc.constantFrom(...HIDDEN),
      fc.constantFrom('\u0301', '\u0489', ' ', '\t', '\n'),
      fc.string({ unit: 'binary' }),
    ),
    {
      maxLength: 200,
    },
  )
  .map((parts) => parts.join(''));

describe('a name as it is shown', () => {
  test('shows no hidden characters, is one short line, and stays the same when processed again', () => {
    fc.assert(
      fc.property(hostileName, (name) => {
        const shown = shownName(name);
        expect(HIDDEN.filter((character) => [...shown].includes(character))).toEqual([]);
        expect(shown).toMatch(/^\S(.*\S)?$/);
        expect(shown).not.toMatch(/\s\s|\p{M}{4}/u);
        expect([...shown].length).toBeLessThanOrEqual(60);
        expect(shownName(shown)).toBe(shown);
      }),
    );
  });

  test('is the name, where it is plain and short', () => {
    for (const name of ['bunny.glb', 'Größe 1.obj', 'モデル.stl', 'דגם.ply', 'a'.repeat(60), 'a\u0301\u0302.glb']) {
      expect(shownName(name)).toBe(name);
    }
    expect(shownName('\u202e\u200b')).toBe('a file without a name');
  });

  test('keeps its beginning and its end, whatever is between', () => {
    const ends = fc.stringMatching(/^[a-z]{10}$/);
    fc.assert(
      fc.property(ends, hostileName, ends, (start, middle, end) => {
        const shown = shownName(`${start}${middle}${end}.glb`);
        expect(shown.startsWith(start)).toBe(true);
        expect(shown.endsWith(`${end}.glb`)).toBe(true);
      }),
    );
    expect(shownName(`start ${'from trusted.test '.repeat(150)}end.glb`)).toMatch(/^start .{20,}….{20,}end\.glb$/);
  });

  test('is not turned round: what is written backwards reads backwards', () => {
    expect(shownName('\u202emoc.elpmaxe morf ,blg.nemow')).toBe('moc.elpmaxe morf ,blg.nemow');
  });
});

test('a sentence is long enough for what is said, and no longer', () => {
  const sentence = `${'word '.repeat(60)}end.`;
  expect(shownText(sentence)).toBe(sentence);
  expect([...shownText('💡'.repeat(1000))]).toHaveLength(400);
  expect(shownText('')).toBe('');
});
