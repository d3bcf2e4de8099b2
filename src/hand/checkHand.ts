import { checkStrokes } from './checkStrokes.js';
import type { Hand } from './Hand.js';
import { HAND_NUMBER_NAMES, HAND_NUMBER_RANGES } from './handNumberRanges.js';

/**
 * Checks that a value, such as one read from JSON, is a hand.
 *
 * @param caller the function that is named in the error
 * @throws TypeError or RangeError that says in a sentence what is wrong
 */
export function checkHand(caller: string, hand: unknown): asserts hand is Hand {
  if (typeof hand !== 'object' || hand === null || Array.isArray(hand)) {
    throw new TypeError(
      `${caller}: hand is ${Array.isArray(hand) ? 'an array' : String(hand)}, but must be { version, strokes, numbers }; learnHand makes one from strokes.`,
    );
  }
  const { version, name, strokes, numbers, mirror } = hand as Partial<Hand>;
  if (version !== 1) throw new RangeError(`${caller}: hand.version is ${String(version)}, but must be 1.`);
  if (name !== undefined && typeof name !== 'string') {
    throw new TypeError(`${caller}: hand.name is ${String(name)}, but must be a text, or left out.`);
  }
  if (mirror !== undefined && typeof mirror !== 'boolean') {
    throw new TypeError(`${caller}: hand.mirror is ${String(mirror)}, but must be true or false, or left out.`);
  }
  checkStrokes(`${caller}: hand`, strokes);
  if (typeof numbers !== 'object' || numbers === null) {
    throw new TypeError(
      `${caller}: hand.numbers is ${String(numbers)}, but must be an object with the learnt numbers.`,
    );
  }
  for (const number of HAND_NUMBER_NAMES) {
    const value: unknown = numbers[number];
    const { from, to } = HAND_NUMBER_RANGES[number];
    if (typeof value !== 'number' || !(value >= from && value <= to)) {
      throw new RangeError(
        `${caller}: hand.numbers.${number} is ${String(value)}, but must be a number from ${from} to ${to}.`,
      );
    }
  }
}
