import type { NumberRange } from '../../look/HatchingProperty.js';

/** The defaults of all properties of `HatchingOutlineMaterial`; colours as 0xrrggbb. */
export const HATCHING_OUTLINE_DEFAULTS = {
  outlineWidth: 1.8,
  weights: {
    contours: 1,
    innerContours: 0.5,
    borders: 1,
    creases: 0.35,
    materialBorders: 0.35,
    intersections: 0.35,
    suggestiveContours: 0,
    lit: 0.7,
    shade: 1.7,
  },
  lostEdges: 0.2,
  accents: 0.5,
  taper: 0.8,
  wobble: 0,
  overshoot: 0,
  paperGrain: 0,
  paperGrainSize: 2.5,
  ink: 0x000000,
  hidden: 'none',
  intersections: false,
} as const;

/** The ranges of the numeric properties. Each has a uniform of the same name. */
export const OUTLINE_NUMBERS = {
  outlineWidth: { above: 0 },
  lostEdges: { from: 0, to: 1 },
  accents: { from: 0 },
  taper: { from: 0 },
  wobble: { from: 0 },
  overshoot: { from: 0 },
  paperGrain: { from: 0, to: 1 },
  paperGrainSize: { above: 0 },
} as const satisfies Partial<Record<keyof typeof HATCHING_OUTLINE_DEFAULTS, NumberRange>>;

export type OutlineNumberName = keyof typeof OUTLINE_NUMBERS;

export type OutlineWeightName = keyof typeof HATCHING_OUTLINE_DEFAULTS.weights;

/** The properties that are measured in CSS pixels. */
export const OUTLINE_SIZES = [
  'outlineWidth',
  'wobble',
  'overshoot',
  'paperGrainSize',
] as const satisfies OutlineNumberName[];

/** The sizes in `look` multiplied by `factor`: for a picture `factor` times as wide at the same pixel ratio. */
export function scaledOutlineSizes<Look extends { readonly [Name in OutlineNumberName]?: unknown }>(
  look: Look,
  factor: number,
): Partial<Look> {
  const given = OUTLINE_SIZES.filter((name) => typeof look[name] === 'number');
  return Object.fromEntries(given.map((name) => [name, Number(look[name]) * factor])) as Partial<Look>;
}

export const OUTLINE_NUMBER_NAMES = /* @__PURE__ */ Object.keys(OUTLINE_NUMBERS) as OutlineNumberName[];

export const OUTLINE_WEIGHT_NAMES = /* @__PURE__ */ Object.keys(
  HATCHING_OUTLINE_DEFAULTS.weights,
) as OutlineWeightName[];

/** The weights of kinds of lines. Each has a uniform of the same name. */
export const WEIGHTED_LINES = /* @__PURE__ */ OUTLINE_WEIGHT_NAMES.filter((name) => name !== 'lit' && name !== 'shade');

const MILLIMETRES_PER_INCH = 25.4;

/**
 * Converts a width on paper to pixels of the picture, for `outlineWidth` and `strokeWidth` at a pixel ratio of 1.
 *
 * @param millimetres the width on paper, above 0
 * @param dpi the resolution of the print in pixels per inch, such as 300 or 600
 * @throws RangeError if either is not a positive number
 */
export function millimetresToPixels(millimetres: number, dpi: number): number {
  if (millimetres > 0 && dpi > 0 && millimetres * dpi < Infinity) return (millimetres * dpi) / MILLIMETRES_PER_INCH;
  throw new RangeError(
    `millimetresToPixels: ${millimetres} mm at ${dpi} dpi. Pass two positive numbers, such as 0.25 and 600.`,
  );
}
