/** How light a luminance looks beside white, both in [0, 1] (CIE 1976), as `lightness.glsl` has it. */
export const lightness = (y: number): number => (y < 216 / 24389 ? y * 9.032963 : 1.16 * Math.cbrt(y) - 0.16);
