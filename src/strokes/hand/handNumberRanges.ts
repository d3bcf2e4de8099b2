import type { HandNumbers } from './Hand.js';

/** The values that a number of a hand may have. */
export interface HandNumberRange {
  from: number;
  to: number;
}

/** The values that each number of a hand may have, in its unit. Lengths in millimetres may be anything that a pen draws. */
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
