import type { Hand } from './Hand.js';
import { HAND_NUMBER_NAMES, HAND_NUMBER_RANGES } from './handNumberRanges.js';

/**
 * Checks that a value has the numbers of a hand. Its strokes are not looked at.
 *
 * @param caller the function that is named in the error
 * @throws TypeError or RangeError that says in a sentence what is wrong
 */
export function checkHandNumbers(caller: string, hand: unknown): asserts hand is Pick<Hand, 'numbers'> {
  checkIsObject(caller, hand);
  const { numbers } = hand as Partial<Hand>;
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

/** @throws TypeError if a value cannot be a hand */
export function checkIsObject(caller: string, hand: unknown): asserts hand is object {
  if (typeof hand === 'object' && hand !== null && !Array.isArray(hand)) return;
  throw new TypeError(
    `${caller}: hand is ${Array.isArray(hand) ? 'an array' : String(hand)}, but must be { version, strokes, numbers }; learnHand makes one from strokes.`,
  );
}
