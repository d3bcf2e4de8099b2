const MAX_PIXEL_RATIO = 2;
/** On very large screens the pixel ratio is lowered to stay below this. */
const MAX_PIXELS = 8_000_000;

/** How many pixels are drawn per CSS pixel of a viewport while nothing moves. `width` and `height` are its size in CSS pixels. */
export const fullPixelRatio = (width: number, height: number): number =>
  Math.min(devicePixelRatio, MAX_PIXEL_RATIO, Math.sqrt(MAX_PIXELS / Math.max(1, width * height)));
