/**
 * Shares a tone among families of lines that cross, as in crossedTones.glsl and hatchLayer.glsl. Printed over one another they give it
 * again.
 */
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';

const { KEPT_SHARE } = TONE_CONSTANTS;
export const { KEPT_BY_PEN, THIRD_FROM } = TONE_CONSTANTS;

/** The part of a tone that a layer prints itself, if other layers cross it above the tone `from`. */
export const takenOf = (tone: number, from: number, kept: number = KEPT_SHARE): number =>
  Math.min(tone, from) + kept * Math.max(tone - from, 0);

/** The tone that a layer leaves to the others: exactly 0 up to where they begin. */
export const leftOf = (tone: number, taken: number): number => Math.max(tone - taken, 0) / Math.max(1 - taken, 1e-4);

/** A tone shared by two families: the one that better crosses the first has the share `shareB`. */
export function sharedByTwo(tone: number, shareB: number): readonly [number, number] {
  const blankB = 1 - shareB * tone;
  return [1 - blankB, 1 - (1 - tone) / Math.max(blankB, 1e-4)];
}

/**
 * The share of side B among families that lean back. Where the first family has no lines, `firstShare` being 0, one of them is left out, since
 * both would coincide with those that cross.
 */
export const otherShare = (shareB: number, firstShare: number): number => shareB + firstShare - 1;
