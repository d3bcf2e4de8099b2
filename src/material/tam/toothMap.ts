import { DataTexture, LinearFilter, RedFormat, RepeatWrapping } from 'three';
import { blurToroidal } from '../../strokes/blurToroidal.js';
import { random } from '../../strokes/random.js';
import { TOOTH_MAP_RADIUS, TOOTH_MAP_SIZE } from './patternSizes.js';

const SEED = 7;

let tooth: DataTexture | undefined;

/**
 * The tooth of the paper: normally distributed noise, with −3 to 3 standard deviations as 0 to 1 in red. Values are low on the bumps
 * of the paper, which take pencil and chalk first. The texture tiles. The first call makes it in a few milliseconds; it is shared and never
 * disposed of.
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

/** Makes blurred noise. Its values are sums of many random numbers, so they are normally distributed. */
function toothTexels(): Uint8Array {
  const next = random(SEED);
  const noise = Float32Array.from({ length: TOOTH_MAP_SIZE ** 2 }, () => next() - 0.5);
  const field = blurToroidal(noise, TOOTH_MAP_SIZE, TOOTH_MAP_RADIUS);
  // The mean is subtracted, because it is not exactly 0 and would shift the tone.
  const mean = field.reduce((sum, value) => sum + value, 0) / field.length;
  const variance = field.reduce((sum, value) => sum + (value - mean) ** 2, 0) / field.length;
  const scale = 255 / (6 * Math.sqrt(variance));
  return Uint8Array.from(field, (value) => Math.min(Math.max(Math.round(127.5 + (value - mean) * scale), 0), 255));
}
