/** Smooth metal that mirrors a room, as in metal.glsl. */
import { METAL_CONSTANTS } from '../../look/constants/metalConstants.js';
import { type Metal, mirroredShare } from '../../look/mirrors.js';
import { dot, mix, smoothstep, type Vec3 } from '../../look/vectors.js';

const { MIRRORED, HORIZON, ROOM, FLOOR } = METAL_CONSTANTS;

/** The share of the tone of a surface that the room decides; 0 where it mirrors nothing. */
export const shareOfRoom = (metal: Metal): number => MIRRORED * mirroredShare(metal);

/** The light of the room where a surface mirrors it, from 0 to 1. World space. @param toViewer unit */
export function mirroredRoom(normal: Vec3, toViewer: Vec3): number {
  const above = 2 * dot(normal, toViewer) * normal[1] - toViewer[1];
  const below = mix(ROOM[0], ROOM[1], smoothstep(FLOOR[0], FLOOR[1], -above));
  return mix(below, 1, smoothstep(-HORIZON, HORIZON, above));
}
