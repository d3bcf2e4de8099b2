import type { StrokeStyle } from './StrokeStyle.js';

/** The names of the stroke styles, separate from the code that draws them. */
export const STROKE_STYLE_NAMES = [
  'hatching',
  'crossHatching',
  'tripleHatching',
  'ruled',
  'contours',
  'dashes',
  'stippling',
  'pencil',
  'charcoal',
  'woodcut',
] as const;

/** A style of strokes. */
export type StrokeStyleName = (typeof STROKE_STYLE_NAMES)[number];

/** The widths of a style's strokes. */
type StrokeWidths = Pick<StrokeStyle, 'width' | 'widthRange'>;

const PEN = [1.2, 2.6] as const;
const DOT = [1.65, 2.5] as const;

/** The widths of each style, separate from the code that draws it. */
export const STROKE_WIDTHS: Readonly<Record<StrokeStyleName, StrokeWidths>> = {
  hatching: { width: 1.9, widthRange: PEN },
  crossHatching: { width: 1.9, widthRange: PEN },
  tripleHatching: { width: 1.7, widthRange: PEN },
  ruled: { width: 1.4, widthRange: PEN },
  contours: { width: 1.8, widthRange: PEN },
  dashes: { width: 2.2, widthRange: DOT },
  stippling: { width: 2.4, widthRange: DOT },
  pencil: { width: 1.8, widthRange: [1.6, 2.4] },
  charcoal: { width: 2.6, widthRange: [2, 2.6] },
  woodcut: { width: 2.5, widthRange: PEN },
};
