/** The luminance of a colour in linear light (Rec. 709), as three's shader chunks have it. */
export const luminanceOf = ({ r, g, b }: { readonly r: number; readonly g: number; readonly b: number }): number =>
  0.2126 * r + 0.7152 * g + 0.0722 * b;

/** How light a luminance looks beside white, both in [0, 1] (CIE 1976), as `lightness.glsl` has it. */
export const lightness = (y: number): number => (y < 216 / 24389 ? y * 9.032963 : 1.16 * Math.cbrt(y) - 0.16);
