import type { Texture } from 'three';
import { lightness, luminanceOf } from '../../look/vectors.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { type Luminances, luminances } from './luminances.js';
import type { SurfaceSamples } from './surfaceSamples.js';

const known = new WeakMap<Texture, { version: number; pixels: Luminances | undefined }>();

/** The pixels of a map, read once per version. */
function pixelsOf(map: Texture): Luminances | undefined {
  const before = known.get(map);
  if (before?.version === map.version) return before.pixels;
  const pixels = luminances(map.image, map);
  known.set(map, { version: map.version, pixels });
  return pixels;
}

/**
 * The lightness of a surface's colour at its samples, relative to white: from its material, its vertices and its map. A map that cannot
 * be read here, or uses texture coordinates other than the first, counts as white.
 */
export function lightnessOf(
  { color, vertexColors, map }: HatchingMaterialProperties,
  { colors, places }: SurfaceSamples,
): (sample: number) => number {
  const own = luminanceOf(color);
  const painted = vertexColors ? colors : undefined;
  const pixels = map && map.channel === 0 && places ? pixelsOf(map) : undefined;
  if (map?.matrixAutoUpdate) map.updateMatrix();
  return (sample) => {
    let luminance = own * (painted?.[sample] ?? 1);
    if (pixels && map && places) {
      const e = map.matrix.elements;
      const [u, v] = [places[2 * sample], places[2 * sample + 1]];
      const across = fraction(e[0] * u + e[3] * v + e[6]);
      const up = fraction(e[1] * u + e[4] * v + e[7]);
      const row = map.flipY ? 1 - up : up;
      luminance *= pixels.at(
        Math.min(pixels.width - 1, Math.floor(across * pixels.width)),
        Math.min(pixels.height - 1, Math.floor(row * pixels.height)),
      );
    }
    return lightness(Math.min(luminance, 1));
  };
}

const fraction = (value: number): number => value - Math.floor(value);
