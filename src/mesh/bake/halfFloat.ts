const float = new Float32Array(1);
const word = new Uint32Array(float.buffer);

/** The largest half float. */
const LARGEST = 65504;

/**
 * The 16 bits of the half float nearest to `value`. Values beyond the largest half float are clamped to it; subnormal values
 * and NaN become 0.
 */
export function halfFloat(value: number): number {
  float[0] = Number.isNaN(value) ? 0 : Math.min(Math.max(value, -LARGEST), LARGEST);
  const bits = word[0];
  const sign = (bits >>> 16) & 0x8000;
  // The bias of the exponent changes from 127 to 15. Adding half of the last bit that is kept rounds to the nearest.
  const magnitude = (bits & 0x7fffffff) - ((127 - 15) << 23) + 0x1000;
  return magnitude < 1 << 23 ? sign : sign | (magnitude >>> 13);
}
