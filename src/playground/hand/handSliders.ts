import type { HandNumbers } from 'three-hatching';

/** A slider for a number of a hand. */
export interface HandSlider {
  label: string;
  /** Text of the tooltip. */
  about: string;
  unit: 'mm' | '%' | '°';
  /** Range and step, in the displayed unit. */
  min: number;
  max: number;
  step: number;
}

/** Sliders for the numbers learnt from a hand, in display order. */
export const HAND_SLIDERS = {
  length: { label: 'Length', about: 'how long a stroke is', unit: 'mm', min: 0.5, max: 60, step: 0.1 },
  lengthSpread: {
    label: 'Length varies',
    about: 'how much strokes differ in length',
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  width: { label: 'Width', about: 'how wide a stroke is', unit: 'mm', min: 0.05, max: 5, step: 0.01 },
  widthSpread: {
    label: 'Pressure',
    about: 'how much the width swells and shrinks',
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  taperStart: {
    label: 'Taper, start',
    about: 'over how much of its length a stroke grows',
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  taperEnd: {
    label: 'Taper, end',
    about: 'over how much of its length a stroke narrows',
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  curvature: {
    label: 'Bend',
    about: 'how high the arc of a stroke is, to either side',
    unit: '%',
    min: -50,
    max: 50,
    step: 0.5,
  },
  wobble: { label: 'Wobble', about: 'how far the line trembles', unit: 'mm', min: 0, max: 1, step: 0.01 },
  angleSpread: {
    label: 'Angle varies',
    about: 'how much strokes differ in direction',
    unit: '°',
    min: 0,
    max: 45,
    step: 0.5,
  },
  spacing: { label: 'Spacing', about: 'from one stroke to the next', unit: 'mm', min: 0.1, max: 12, step: 0.05 },
  spacingSpread: {
    label: 'Spacing varies',
    about: 'evenly at 0, by chance at 100',
    unit: '%',
    min: 0,
    max: 150,
    step: 1,
  },
  clustering: {
    label: 'In groups',
    about: 'evenly at 0, in bundles with gaps towards 100',
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  overlap: {
    label: 'Overlap',
    about: 'how much of a stroke runs beside the next of its row; below 0 there are gaps',
    unit: '%',
    min: -100,
    max: 100,
    step: 1,
  },
  crossingAngle: {
    label: 'Crossing at',
    about: 'the angle of the second layer; none at 0',
    unit: '°',
    min: -90,
    max: 90,
    step: 1,
  },
  crossingFrom: {
    label: 'Crossing from',
    about: 'the tone from which strokes cross; never at 100',
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
} as const satisfies Record<keyof HandNumbers, HandSlider>;

export const HAND_NUMBER_NAMES = Object.keys(HAND_SLIDERS) as (keyof HandNumbers)[];

const factorOf = ({ unit }: HandSlider): number => (unit === '%' ? 100 : 1);

/** A hand's number in the displayed unit, within the slider's range. */
export function shownNumber(name: keyof HandNumbers, value: number): number {
  const slider: HandSlider = HAND_SLIDERS[name];
  return Math.min(slider.max, Math.max(slider.min, value * factorOf(slider)));
}

/** A hand's number from a slider's value. */
export const numberOfShown = (name: keyof HandNumbers, shown: number): number => shown / factorOf(HAND_SLIDERS[name]);

/** A number with its unit, with as many decimals as its step has. */
export function inUnit(name: keyof HandNumbers, shown: number): string {
  const { step, unit }: HandSlider = HAND_SLIDERS[name];
  const decimals = step >= 1 ? 0 : step >= 0.1 ? 1 : 2;
  // Avoids −0.
  const text = (Number(shown.toFixed(decimals)) + 0).toFixed(decimals).replace('-', '−');
  return unit === '°' ? `${text}°` : `${text} ${unit}`;
}
