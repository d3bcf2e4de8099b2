/**
 * The component of `hatchNormal` that holds baked ambient occlusion, as a normalised 16-bit integer. Where one side of a surface is drawn,
 * it is minus the occlusion of that side, in steps of 1 / 32767. Where both are drawn, it is positive and holds two numbers of
 * `SIDE_LEVELS` levels: that of the front times `SIDE_LEVELS`, plus that of the back. 32767 stands for no occlusion: WebGL reads 1 if the
 * attribute is missing, and that must not darken anything.
 */

/** The normalised 16-bit integer that stands for 1. */
const ONE = 0x7fff;

/** The number of levels of each side, as a constant that shaders share: the greatest number whose square is below 32767. */
export const OCCLUSION_LEVELS = { SIDE_LEVELS: 181 } as const;
const { SIDE_LEVELS } = OCCLUSION_LEVELS;

/** The component for the occlusion of the side that is drawn, from 0 (sees the whole sky) to 1 (sees nothing of it). */
export const packedSide = (occlusion: number): number => -Math.round(ONE * occlusion);

/** The component for the occlusion of front and back. */
export const packedSides = (front: number, back: number): number =>
  SIDE_LEVELS * Math.round((SIDE_LEVELS - 1) * front) + Math.round((SIDE_LEVELS - 1) * back);

/**
 * The occlusion of the front or the back.
 *
 * @param w the component, as a share of 1
 */
export function occlusionOf(w: number, isBack: boolean): number {
  if (w < 0) return -w;
  if (w >= 1) return 0;
  const both = Math.round(ONE * w);
  return (isBack ? both % SIDE_LEVELS : Math.floor(both / SIDE_LEVELS)) / (SIDE_LEVELS - 1);
}
