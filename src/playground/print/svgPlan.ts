import { hasEffect } from '../../viewer/settings/effects.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { type PrintPlan, sheetSides, toMillimetres } from './printPlan.js';

/** CSS pixels per inch, for drawings in page size. */
const CSS_DPI = 96;
const MILLIMETRES_PER_INCH = 25.4;
/** The maximum number of pixels of a raster picture in a vector file: an A2 sheet at 300 dpi. Programs hold the whole file in memory. */
const MOST_PIXELS = 36_000_000;

/** The layout of a vector drawing on its sheet. Lengths are in millimetres. */
export interface SvgPlan {
  sheet: readonly [width: number, height: number];
  margin: number;
  /** The picture within the margins. Its dots per inch are those of the sheet. */
  within: PrintPlan;
}

/**
 * Lays a picture out on the sheet of a vector file. It is shrunk, strokes included, to fit within the margins; if their proportions differ
 * from the sheet's, it shows a little more of the view.
 *
 * @throws Error with a sentence for the user, if the margins leave no room
 */
export function planSvg(settings: Settings, plan: PrintPlan): SvgPlan {
  const isSheet = hasEffect('pictureMargin', settings);
  const dpi = Number.isFinite(Number(settings.pictureSize)) ? CSS_DPI : plan.dpi;
  // A picture has a whole number of pixels, so it differs from its sheet by up to half a pixel.
  const exact = [plan.width, plan.height].map((pixels) => toMillimetres(pixels, dpi));
  const sides = isSheet ? sheetSides(settings) : undefined;
  const [width, height] = exact.map((side) => (sides ? nearest(sides, side) : Math.round(10 * side) / 10));
  const margin = isSheet ? settings.pictureMargin : 0;
  const room = isSheet ? [width - 2 * margin, height - 2 * margin] : exact;
  if (Math.min(...room) < 1) {
    const size = [width, height].map(Math.round).join(' × ');
    throw new Error(`margins of ${margin} mm leave no room on a sheet of ${size} mm. Make them smaller.`);
  }
  const perMillimetre = Math.max(plan.width / room[0], plan.height / room[1]);
  const [left, top] = [plan.width, plan.height].map((pixels, i) => Math.round((room[i] * perMillimetre - pixels) / 2));
  const within = {
    ...plan,
    width: plan.width + 2 * left,
    height: plan.height + 2 * top,
    left: plan.left - left,
    top: plan.top - top,
    dpi: perMillimetre * MILLIMETRES_PER_INCH,
  };
  return { sheet: [width, height], margin, within };
}

const nearest = ([one, other]: readonly [number, number], side: number): number =>
  Math.abs(one - side) <= Math.abs(other - side) ? one : other;

/** The same picture at another resolution: `dpi`, or the finest that a file can hold. */
export function printablePlan(plan: PrintPlan, dpi: number): PrintPlan {
  const factor = Math.min(dpi / plan.dpi, Math.sqrt(MOST_PIXELS / (plan.width * plan.height)));
  const [width, height] = [plan.width, plan.height].map((pixels) => Math.round(pixels * factor));
  // Whole pixels keep the picture's edges in place.
  const [wide, high] = [width / plan.width, height / plan.height];
  return {
    ...{ width, height },
    viewWidth: plan.viewWidth * wide,
    viewHeight: plan.viewHeight * high,
    left: plan.left * wide,
    top: plan.top * high,
    scale: plan.scale * wide,
    dpi: plan.dpi * wide,
  };
}
