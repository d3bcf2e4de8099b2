import type { NumberRange } from '../look/HatchingProperty.js';

/** The defaults of all properties of `HatchingBackground`; the colour as 0xrrggbb. */
export const HATCHING_BACKGROUND_DEFAULTS = {
  tone: 0.25,
  contrast: 0.75,
  spacing: 6,
  direction: Math.PI / 5,
  extent: 1.4,
  ink: 0x000000,
} as const;

/** The ranges of the numeric properties. */
export const BACKGROUND_NUMBERS = {
  tone: { from: 0, to: 1 },
  contrast: { from: 0, to: 1 },
  spacing: { above: 0 },
  direction: {},
  extent: { above: 0 },
} as const satisfies Partial<Record<keyof typeof HATCHING_BACKGROUND_DEFAULTS, NumberRange>>;

export type BackgroundNumberName = keyof typeof BACKGROUND_NUMBERS;

export const BACKGROUND_NUMBER_NAMES = /* @__PURE__ */ Object.keys(BACKGROUND_NUMBERS) as BackgroundNumberName[];
