/** The luminance of a colour in linear light (Rec. 709), as in three's shader chunks. */
export const luminanceOf = ({ r, g, b }: { readonly r: number; readonly g: number; readonly b: number }): number =>
  0.2126 * r + 0.7152 * g + 0.0722 * b;

/** The CIE 1976 lightness of a luminance, both in [0, 1], as in `lightness.glsl`. */
export const lightness = (y: number): number => (y < 216 / 24389 ? y * 9.032963 : 1.16 * Math.cbrt(y) - 0.16);
