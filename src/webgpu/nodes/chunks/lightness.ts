/** Counterpart of shaders/chunks/lightness.glsl. */
import { tsl, type Value } from '../base/values.js';

const { pow, select } = tsl;

/** Lightness L* over 100, of a luminance in [0, 1] (CIE 1976). */
export const lightness = (y: Value): Value =>
  select(
    y.lessThan(216 / 24389),
    y.mul(9.032963),
    pow(y, 1 / 3)
      .mul(1.16)
      .sub(0.16),
  );
