/** The names of the stroke styles, for who must know them without being able to draw them. */
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
