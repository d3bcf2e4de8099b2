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
