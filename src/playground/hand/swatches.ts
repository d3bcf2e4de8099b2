import type { SwatchTone } from 'three-hatching';

/** A field of the sheet, in millimetres from its top left corner. */
export interface Swatch {
  tone: SwatchTone;
  label: string;
  /** How dark it shall become, from 0 (paper) to 1. */
  darkness: number;
  top: number;
  bottom: number;
}

/** The fields lie below each other, the lightest on top. */
export const SWATCHES: readonly Swatch[] = [
  { tone: 'light', label: 'Light', darkness: 0.2, top: 0, bottom: 24 },
  { tone: 'middle', label: 'Middle', darkness: 0.45, top: 24, bottom: 48 },
  { tone: 'dark', label: 'Dark', darkness: 0.75, top: 48, bottom: 72 },
];

/** The size of the sheet on which a hand is drawn, in millimetres. */
export const SHEET = { width: 76, height: 72 } as const;

/** The tone of the field in which a point lies; that of the nearest for points outside. */
export const swatchAt = (y: number): SwatchTone =>
  (SWATCHES.find(({ bottom }) => y < bottom) ?? SWATCHES[SWATCHES.length - 1]).tone;
