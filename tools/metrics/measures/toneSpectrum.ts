import type { SurfaceImage } from './SurfaceImage.js';

/** The shortest wavelength of each band but the last, and the longest of that one, in pixels. */
export const BANDS = [2, 4, 8, 16, 32, 64] as const;

/**
 * The spectrum of an even tone: the standard deviation of the tone in bands of wavelength, an octave each. A fine, even texture has its
 * deviation in the bands of its dots or strokes, and next to none in those of longer waves, which the eye sees as marbling.
 *
 * @param image a square of surface whose side is a power of two
 */
export function toneSpectrum({ width, luminance }: SurfaceImage): number[] {
  const mean = luminance.reduce((sum, value) => sum + value, 0) / luminance.length;
  // Hann's window keeps the borders of the picture, where it does not tile, from counting as waves.
  const hann = Float64Array.from({ length: width }, (_, i) => 1 - Math.cos((2 * Math.PI * (i + 0.5)) / width));
  const real = Float64Array.from(
    luminance,
    (value, i) => (value - mean) * hann[i % width] * hann[Math.floor(i / width)],
  );
  const imaginary = new Float64Array(real.length);
  for (let line = 0; line < width; line++) transform(real, imaginary, line * width, 1, width);
  for (let line = 0; line < width; line++) transform(real, imaginary, line, width, width);
  const variances = new Array<number>(BANDS.length - 1).fill(0);
  const signed = (i: number): number => (i < width / 2 ? i : i - width) / width;
  for (let i = 0; i < real.length; i++) {
    const wavelength = 1 / Math.hypot(signed(i % width), signed(Math.floor(i / width)));
    const band = BANDS.findLastIndex((shortest) => shortest <= wavelength);
    // Hann's window squared has a mean of 3/2 along each axis.
    if (band >= 0 && band < variances.length)
      variances[band] += (real[i] ** 2 + imaginary[i] ** 2) / (2.25 * real.length ** 2);
  }
  return variances.map(Math.sqrt);
}

/** The discrete Fourier transform of one row or column, in place (Cooley and Tukey 1965). length: a power of two. */
function transform(real: Float64Array, imaginary: Float64Array, first: number, stride: number, length: number): void {
  const swap = (values: Float64Array, i: number, j: number) => {
    const [a, b] = [first + i * stride, first + j * stride];
    [values[a], values[b]] = [values[b], values[a]];
  };
  for (let i = 1, reversed = 0; i < length; i++) {
    let bit = length >> 1;
    for (; reversed & bit; bit >>= 1) reversed ^= bit;
    reversed ^= bit;
    if (i < reversed) for (const values of [real, imaginary]) swap(values, i, reversed);
  }
  for (let half = 1; half < length; half *= 2) {
    for (let k = 0; k < half; k++) {
      const [cos, sin] = [Math.cos((Math.PI * k) / half), -Math.sin((Math.PI * k) / half)];
      for (let i = k; i < length; i += 2 * half) {
        const [even, odd] = [first + i * stride, first + (i + half) * stride];
        const x = cos * real[odd] - sin * imaginary[odd];
        const y = cos * imaginary[odd] + sin * real[odd];
        real[odd] = real[even] - x;
        imaginary[odd] = imaginary[even] - y;
        real[even] += x;
        imaginary[even] += y;
      }
    }
  }
}
