import { expect, test } from 'vitest';
import { readHandFile, readLinkedHand } from '../../../../src/playground/hand/ownHand.js';
import { linkedHand } from '../../../../src/playground/session/DrawingState.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../../../src/strokes/hands/drawSwatch.js';
import { exampleHabits } from '../../../../src/strokes/hands/exampleHabits.js';
import { writeHand } from '../../../../src/viewer/settings/handLink.js';

const hand = learnHand(drawSwatches(exampleHabits.brush, 1));
const fileOf = (value: unknown) => ({ name: 'mine.json', content: new Blob([JSON.stringify(value)]) });

test('the file of a hand gives back the same hand, and is written into the same file', async () => {
  const own = (await readHandFile(fileOf(hand)))!;
  expect(own.hand).toEqual(hand);
  expect(own.strokes).toEqual(hand.strokes);
  expect((await readHandFile(own.files![0]))!.hand).toEqual(hand);
});

test('what is no hand is left to others; a damaged hand is refused in a sentence that names the file', async () => {
  for (const other of [{ images: [] }, [], 5, null]) expect(await readHandFile(fileOf(other))).toBeUndefined();
  expect(await readHandFile({ name: 'a.json', content: new Blob(['{']) })).toBeUndefined();
  const damaged = [
    { ...hand, strokes: [] },
    { ...hand, strokes: [{ points: [0, 0, Number.NaN, 1], widths: [1, 1] }] },
    { ...hand, numbers: { ...hand.numbers, width: -1 } },
    { strokes: hand.strokes },
  ];
  for (const value of damaged) {
    await expect(readHandFile(fileOf(value))).rejects.toThrow(/^mine\.json: .+\.$/);
  }
});

test('a hand from a link is read when it is drawn with, and keeps its text', () => {
  const { link } = readLinkedHand({ ...linkedHand('x')!, hand, strokes: hand.strokes })!;
  expect(link).toBe('x');
  const text = readHandText();
  const own = readLinkedHand(linkedHand(text)!)!;
  expect(own.link).toBe(text);
  expect(own.strokes).toHaveLength(hand.strokes.length);
  expect(own.hand!.numbers.length).toBeCloseTo(hand.numbers.length, 2);
  expect(readLinkedHand(linkedHand('AAAA')!)).toBeUndefined();
});

function readHandText(): string {
  const few = { ...hand, strokes: hand.strokes };
  const text = writeHand(few);
  if (text === undefined) throw new Error('The hand is too long for a link.');
  return text;
}
