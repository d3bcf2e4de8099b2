import type { SwatchTone } from 'three-hatching';

/** A field of the sheet, in millimetres from its top left corner. */
export interface Swatch {
  tone: SwatchTone;
  label: string;
  /** Intended darkness, from 0 (paper) to 1. */
  darkness: number;
  top: number;
  bottom: number;
}

/** The fields, from the lightest at the top downwards. */
export const SWATCHES: readonly Swatch[] = [
  { tone: 'light', label: 'Light', darkness: 0.2, top: 0, bottom: 24 },
  { tone: 'middle', label: 'Middle', darkness: 0.45, top: 24, bottom: 48 },
  { tone: 'dark', label: 'Dark', darkness: 0.75, top: 48, bottom: 72 },
];

/** Size of the sheet, in millimetres. */
export const SHEET = { width: 76, height: 72 } as const;

/** The tone of the field at a height; that of the nearest field outside. */
export const swatchAt = (y: number): SwatchTone =>
  (SWATCHES.find(({ bottom }) => y < bottom) ?? SWATCHES[SWATCHES.length - 1]).tone;
