/**
 * Pixels rendered per CSS pixel, on any screen. Panels are small, so their strokes are drawn in double resolution and
 * scaled down.
 */
export const PIXEL_RATIO = 2;
