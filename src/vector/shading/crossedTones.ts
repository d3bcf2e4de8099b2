/** Shares a tone among families of lines that cross, as crossedTones.glsl and hatchLayer.glsl have it. Printed over one another they give it again. */
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';

const { KEPT_SHARE } = TONE_CONSTANTS;
export const { KEPT_BY_PEN, THIRD_FROM } = TONE_CONSTANTS;

/** The part of a tone that a layer prints itself, where others cross it from the tone `from` on. */
export const takenOf = (tone: number, from: number, kept: number = KEPT_SHARE): number =>
  Math.min(tone, from) + kept * Math.max(tone - from, 0);

/** The tone that it leaves to the others: exactly 0 up to where they begin. */
export const leftOf = (tone: number, taken: number): number => Math.max(tone - taken, 0) / Math.max(1 - taken, 1e-4);

/** A tone as two families share it: that which runs better across the first has the share `shareB`. */
export function sharedByTwo(tone: number, shareB: number): readonly [number, number] {
  const blankB = 1 - shareB * tone;
  return [1 - blankB, 1 - (1 - tone) / Math.max(blankB, 1e-4)];
}

/**
 * The share of side B among families that lean the other way. Where the first family has no lines, `has` being 0, one side is left to the
 * families that lean either way: they would lie along one another.
 */
export const otherShare = (shareB: number, has: number): number => shareB + has - 1;
