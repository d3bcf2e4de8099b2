import { type Hand, type HandNumbers, type HandStroke, learnHand } from 'three-hatching';
import type { OwnHand } from '../maps/OwnHand.js';
import { ownHandOf } from '../maps/readOwnHand.js';

/** The least number of strokes that make a hand. */
export const LEAST_STROKES = 5;

/**
 * The user's own hand with other strokes: learnt anew from {@link LEAST_STROKES} strokes on, except for numbers that the user has changed.
 * Undefined without strokes.
 */
export function learnOwnHand(strokes: readonly HandStroke[], changed: Partial<HandNumbers>): OwnHand | undefined {
  if (strokes.length === 0) return undefined;
  const none: OwnHand = { strokes, hand: undefined, changed, link: undefined, files: undefined };
  if (strokes.length < LEAST_STROKES) return none;
  try {
    return withNumbers({ ...none, hand: learnHand(strokes) }, changed);
  } catch (error) {
    // Nothing can be learnt from dots alone.
    if (error instanceof RangeError) return none;
    throw error;
  }
}

/** The relative tolerance within which a number counts as learnt: strokes are rounded in storage. */
const CHANGED_SHARE = 0.1;
const CHANGED_STEPS = 0.02;

/** The numbers of a hand that differ from those learnt from its strokes, because the user changed them. */
export function changedNumbers({ strokes, numbers }: Hand): Partial<HandNumbers> {
  const learnt = learnHand(strokes).numbers;
  const names = Object.keys(numbers) as (keyof HandNumbers)[];
  const isChanged = (name: keyof HandNumbers): boolean =>
    Math.abs(numbers[name] - learnt[name]) > CHANGED_STEPS + CHANGED_SHARE * Math.abs(learnt[name]);
  return Object.fromEntries(names.filter(isChanged).map((name) => [name, numbers[name]]));
}

/** The hand with some numbers changed. */
export function withNumbers(own: OwnHand, changed: Partial<HandNumbers>): OwnHand {
  if (!own.hand) return { ...own, changed };
  const hand = { ...own.hand, numbers: { ...own.hand.numbers, ...changed } };
  return ownHandOf(hand, own.strokes, changed);
}
