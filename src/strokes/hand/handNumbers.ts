import type { Hand, HandNumbers } from './Hand.js';

/** The range of a number of a hand. */
export interface HandNumberRange {
  from: number;
  to: number;
}

/** The range of each number of a hand, in its unit. Lengths in millimetres may be anything that a pen draws. */
export const HAND_NUMBER_RANGES: Readonly<Record<keyof HandNumbers, HandNumberRange>> = {
  length: { from: 0.001, to: 10_000 },
  lengthSpread: { from: 0, to: 2 },
  curvature: { from: -1, to: 1 },
  taperStart: { from: 0, to: 1 },
  taperEnd: { from: 0, to: 1 },
  width: { from: 0.001, to: 10_000 },
  widthSpread: { from: 0, to: 2 },
  wobble: { from: 0, to: 10_000 },
  angleSpread: { from: 0, to: 90 },
  spacing: { from: 0.001, to: 10_000 },
  spacingSpread: { from: 0, to: 3 },
  clustering: { from: 0, to: 1 },
  overlap: { from: -2, to: 1 },
  crossingAngle: { from: -90, to: 90 },
  crossingFrom: { from: 0, to: 1 },
};

/** The names of the numbers of a hand. */
export const HAND_NUMBER_NAMES = /* @__PURE__ */ Object.keys(HAND_NUMBER_RANGES) as (keyof HandNumbers)[];

/**
 * Checks that a value has the numbers of a hand. Its strokes are not checked.
 *
 * @param caller the function named in the error
 * @throws TypeError or RangeError with the fault
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
