import type { SeenSurface } from './seenSurface.js';

/** A surface that reflects less than this share of the light looks less than half as bright as one that faces it (sRGB). */
const LOOKS_HALF_AS_BRIGHT = 0.214;

/**
 * The share of a seen surface that lies in shade under a distant light: where a white Lambert surface looks less than half as bright as
 * where it faces the light. Hollows darken it as far as their occlusion is known; cast shadows do not count.
 *
 * @param direction unit vector to the light
 * @returns from 0 to 1; 0 if nothing is seen
 */
export function shareOfShade({ normals, openness, pixels }: SeenSurface, [x, y, z]: readonly number[]): number {
  let dark = 0;
  let all = 0;
  for (let part = 0, i = 0; part < pixels.length; part++, i += 3) {
    const facing = normals[i] * x + normals[i + 1] * y + normals[i + 2] * z;
    if (facing * openness[part] < LOOKS_HALF_AS_BRIGHT) dark += pixels[part];
    all += pixels[part];
  }
  return all > 0 ? dark / all : 0;
}
