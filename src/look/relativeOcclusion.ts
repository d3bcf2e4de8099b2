/**
 * Occlusion relative to that of the open parts of a room, as in occlude.glsl: 0 up to there.
 *
 * @param open the occlusion of the open parts, from 0 to less than 1; at 0 nothing changes
 */
export const relativeOcclusion = (occluded: number, open: number): number => Math.max(occluded - open, 0) / (1 - open);
