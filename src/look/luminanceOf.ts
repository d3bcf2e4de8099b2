/** The luminance of a colour in linear light (Rec. 709), as three's shader chunks have it. */
export const luminanceOf = ({ r, g, b }: { readonly r: number; readonly g: number; readonly b: number }): number =>
  0.2126 * r + 0.7152 * g + 0.0722 * b;
