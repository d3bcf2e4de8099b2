import { DataTexture, LinearFilter, RedFormat, RepeatWrapping } from 'three';
import { blurToroidal } from '../strokes/blurToroidal.js';
import { random } from '../strokes/random.js';

/** Texels per side: a power of two. */
export const TOOTH_MAP_SIZE = 256;
/** The blur that the shader knows of: neighbouring texels share 16/19 of their variance. */
const RADIUS = 2;
/** Texels to a bump of the tooth: what that blur leaves. */
export const TOOTH_MAP_BUMP = 2 * RADIUS;
const SEED = 7;

let tooth: DataTexture | undefined;

/**
 * The tooth of paper: a field on which every value is as frequent as in a standard normal distribution, −3 to 3 as 0 to 1 of red,
 * low where the paper stands up and takes the medium first. Tiles. Made when first asked for, in some milliseconds; shared and
 * never disposed of.
 */
export function toothMap(): DataTexture {
  if (tooth === undefined) {
    tooth = new DataTexture(toothTexels(), TOOTH_MAP_SIZE, TOOTH_MAP_SIZE, RedFormat);
    tooth.wrapS = tooth.wrapT = RepeatWrapping;
    tooth.magFilter = tooth.minFilter = LinearFilter;
    tooth.needsUpdate = true;
  }
  return tooth;
}

/** Blurred noise: sums of many numbers, which are normally distributed. */
function toothTexels(): Uint8Array {
  const next = random(SEED);
  const noise = Float32Array.from({ length: TOOTH_MAP_SIZE ** 2 }, () => next() - 0.5);
  const field = blurToroidal(noise, TOOTH_MAP_SIZE, RADIUS);
  // The mean of many texels is 0 but for noise, and what is left of it would be an error of tone.
  const mean = field.reduce((sum, value) => sum + value, 0) / field.length;
  const variance = field.reduce((sum, value) => sum + (value - mean) ** 2, 0) / field.length;
  const scale = 255 / (6 * Math.sqrt(variance));
  return Uint8Array.from(field, (value) => Math.min(Math.max(Math.round(127.5 + (value - mean) * scale), 0), 255));
}
