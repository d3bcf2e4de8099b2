import { Color, SRGBColorSpace } from 'three';

/**
 * Converts sRGB triples to linear RGB in [0, 1]. NaN becomes white.
 *
 * @param full the value of full brightness
 */
export function linearColors(values: ArrayLike<number>, full: number): Float32Array {
  const linear = new Float32Array(values.length);
  const color = new Color();
  const share = (value: number): number => (Number.isFinite(value) ? Math.min(Math.max(value / full, 0), 1) : 1);
  for (let i = 0; i < values.length; i += 3) {
    color.setRGB(share(values[i]), share(values[i + 1]), share(values[i + 2]), SRGBColorSpace).toArray(linear, i);
  }
  return linear;
}
