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
