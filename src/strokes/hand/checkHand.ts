import { checkHandNumbers, checkIsObject } from './checkHandNumbers.js';
import { checkStrokes } from './checkStrokes.js';
import type { Hand } from './Hand.js';

/**
 * Checks that a value, such as one read from JSON, is a hand.
 *
 * @param caller the function that is named in the error
 * @throws TypeError or RangeError that says in a sentence what is wrong
 */
export function checkHand(caller: string, hand: unknown): asserts hand is Hand {
  checkIsObject(caller, hand);
  const { version, name, strokes, mirror } = hand as Partial<Hand>;
  if (version !== 1) throw new RangeError(`${caller}: hand.version is ${String(version)}, but must be 1.`);
  if (name !== undefined && typeof name !== 'string') {
    throw new TypeError(`${caller}: hand.name is ${String(name)}, but must be a text, or left out.`);
  }
  if (mirror !== undefined && typeof mirror !== 'boolean') {
    throw new TypeError(`${caller}: hand.mirror is ${String(mirror)}, but must be true or false, or left out.`);
  }
  checkStrokes(`${caller}: hand`, strokes);
  checkHandNumbers(caller, hand);
}
