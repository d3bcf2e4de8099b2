import { type Hand, learnHand } from 'three-hatching';
import { drawSwatches } from './drawSwatch.js';
import { exampleHabits, type PenHabits } from './exampleHabits.js';

/** The names of the hands. */
export type ExampleHandName = keyof typeof exampleHabits;

/** The names of the hands that `exampleHand` draws. */
export const exampleHandNames = /* @__PURE__ */ Object.keys(exampleHabits) as ExampleHandName[];

/** The names shown to people. */
const TITLES: Readonly<Record<ExampleHandName, string>> = {
  brush: 'Pointed brush',
  dryBrush: 'Dry brush',
  reedPen: 'Reed pen',
  finePen: 'Steel pen',
  quill: 'Quill',
  ballpoint: 'Ballpoint',
  feltTip: 'Felt tip',
  softPencil: 'Soft pencil',
  crayon: 'Crayon',
  woodcut: 'Woodcut tool',
  scribble: 'Scribble',
  etchingNeedle: 'Etching needle',
};

/** High enough to keep all strokes, of which small ones are many. */
const MOST_STROKES = 1000;
/** The points of strokes with grain, which few do not hold. */
const GRAIN_POINTS = 48;

/** Options of `exampleHand`. */
export interface ExampleHandOptions {
  /** A whole number. Each seed draws other strokes in the same manner; the same seed gives the same strokes. Default 1. */
  seed?: number | undefined;
}

/**
 * Draws one of twelve hands: three swatches of strokes, light, middle and dark, and the numbers that `learnHand` learns from them. It is data
 * like any other hand: draw maps with it, look at it, or start your own from it.
 *
 * @throws RangeError for an unknown name, or a seed that is no whole number
 */
export function exampleHand(name: ExampleHandName, { seed = 1 }: ExampleHandOptions = {}): Hand {
  if (!Object.hasOwn(exampleHabits, name)) {
    throw new RangeError(`exampleHand: there is no hand "${String(name)}"; use one of ${exampleHandNames.join(', ')}.`);
  }
  if (!Number.isSafeInteger(seed)) {
    throw new RangeError(`exampleHand: seed is ${String(seed)}, but must be a whole number.`);
  }
  const habits: PenHabits = exampleHabits[name];
  return learnHand(drawSwatches(habits, seed), {
    name: TITLES[name],
    maxStrokes: MOST_STROKES,
    ...(habits.grain && { maxPoints: GRAIN_POINTS }),
  });
}
