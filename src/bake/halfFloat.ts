const float = new Float32Array(1);
const word = new Uint32Array(float.buffer);

/** The largest half float. */
const LARGEST = 65504;

/** The sixteen bits of the half float nearest to `value`; the largest where it lies beyond, 0 where it is below
 * the normal ones or no number. */
export function halfFloat(value: number): number {
  float[0] = Number.isNaN(value) ? 0 : Math.min(Math.max(value, -LARGEST), LARGEST);
  const bits = word[0];
  const sign = (bits >>> 16) & 0x8000;
  // The exponent's offset goes from 127 to 15; half of the last kept bit rounds.
  const magnitude = (bits & 0x7fffffff) - ((127 - 15) << 23) + 0x1000;
  return magnitude < 1 << 23 ? sign : sign | (magnitude >>> 13);
}
