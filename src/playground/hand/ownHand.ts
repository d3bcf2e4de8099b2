import { type Hand, type HandNumbers, type HandStroke, learnHand } from 'three-hatching';
import { checkHand } from '../../strokes/hand/checkHand.js';
import { ModelError, shownName } from '../../viewer/files/common/ModelError.js';
import type { ModelFile } from '../../viewer/files/common/ModelFile.js';
import { readHand, writeHand } from '../../viewer/settings/handLink.js';
import { HAND_FILE, type OwnHand } from '../session/DrawingState.js';

/** Creates the user's own hand, with its text for links and its file. */
export const ownHandOf = (
  hand: Hand,
  strokes: readonly HandStroke[] = hand.strokes,
  changed?: Partial<HandNumbers>,
  link = writeHand(hand),
): OwnHand => ({
  ...{ hand, strokes, changed, link },
  files: [{ name: HAND_FILE, content: new Blob([JSON.stringify(hand)], { type: 'application/json' }) }],
});

/** Reads a hand from a link. Undefined if it is damaged. */
export function readLinkedHand(own: OwnHand): OwnHand | undefined {
  if (own.hand || own.link === undefined) return own;
  const hand = readHand(own.link);
  return hand && ownHandOf(hand, hand.strokes, undefined, own.link);
}

/** The maximum size of a hand's file, far above that of the maximum of 100,000 points. */
const MOST_BYTES = 8 * 1024 * 1024;

/** Keys that the JSON of a hand has, and no other file that the page reads. */
const SIGNS = ['strokes', 'numbers'];

/** Reads the file of a hand. Undefined for other files. @throws ModelError with a sentence for the user, if it is damaged */
export async function readHandFile({ name, content }: ModelFile): Promise<OwnHand | undefined> {
  if (content.size > MOST_BYTES) return undefined;
  let value: unknown;
  try {
    value = JSON.parse(await content.text());
  } catch {
    return undefined;
  }
  if (typeof value !== 'object' || value === null || !SIGNS.some((sign) => Object.hasOwn(value, sign)))
    return undefined;
  const shown = shownName(name);
  try {
    checkHand(shown, value);
  } catch (error) {
    throw new ModelError((error as Error).message);
  }
  return ownHandOf(value);
}

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
