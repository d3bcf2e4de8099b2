/** Light from all around (ambient, hemisphere, probes, environment), as in three's shader chunks. All in world space. */
import type { Vec3 } from './vectors.js';

/** Nine coefficients of spherical harmonics of the luminance, in the order of three's `SphericalHarmonics3`. */
export type Harmonics = Float64Array;

/** A hemisphere light: the direction to its sky, the mean of its two luminances and half their difference. */
export interface Sky {
  up: Vec3;
  mean: number;
  difference: number;
}

/** Ambient and hemisphere lights, light probes and the environment of a scene, as plain data. */
export interface Surroundings {
  ambient: number;
  skies: Sky[];
  probes: Harmonics;
  /** `into` has three rows, which rotate world directions into the space of the environment. */
  environment: { harmonics: Harmonics; intensity: number; into: readonly [Vec3, Vec3, Vec3] } | null;
}

/** The irradiance at a surface with a normal. */
function irradianceFrom(c: Harmonics, x: number, y: number, z: number): number {
  return (
    0.886227 * c[0] +
    1.023328 * (c[1] * y + c[2] * z + c[3] * x) +
    0.858086 * (c[4] * x * y + c[5] * y * z + c[7] * x * z) +
    c[6] * (0.743125 * z * z - 0.247708) +
    0.429043 * c[8] * (x * x - y * y)
  );
}

/** The radiance of a white surface with the unit normal (x, y, z) under this light. Allocates nothing. */
export function radianceAround(
  { ambient, skies, probes, environment }: Surroundings,
  x: number,
  y: number,
  z: number,
): number {
  let sum = ambient + irradianceFrom(probes, x, y, z);
  for (const { up, mean, difference } of skies) sum += mean + difference * (x * up[0] + y * up[1] + z * up[2]);
  if (environment) {
    const [a, b, c] = environment.into;
    sum +=
      environment.intensity *
      irradianceFrom(
        environment.harmonics,
        a[0] * x + a[1] * y + a[2] * z,
        b[0] * x + b[1] * y + b[2] * z,
        c[0] * x + c[1] * y + c[2] * z,
      );
  }
  return Math.max(0, sum) / Math.PI;
}
