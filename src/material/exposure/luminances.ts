import type { Texture } from 'three';
import { lightness, luminanceOf } from '../../look/vectors.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { decoderOf } from '../readImage.js';
import type { SurfaceSamples } from './surfaceSamples.js';

/** The luminances of an image's pixels in linear light, from the first row of the file. */
export interface Luminances {
  width: number;
  height: number;
  at(column: number, row: number): number;
}

/** The width to which images of the browser are scaled before they are read. */
const WIDTH = 256;
const HEIGHT = 128;

/** The luminances of a texture's image, if this thread can read it. */
export function luminances(image: unknown, texture: Texture): Luminances | undefined {
  const { width, height, data } = pixelsOf(image) ?? {};
  if (!width || !height || !data) return undefined;
  const channels = data.length / (width * height);
  const decode = decoderOf(texture, data);
  const at = (column: number, row: number): number => {
    const i = channels * (row * width + column);
    return channels < 3 ? decode(i, 0) : 0.2126 * decode(i, 0) + 0.7152 * decode(i + 1, 1) + 0.0722 * decode(i + 2, 2);
  };
  return { width, height, at };
}

interface Pixels {
  width: number;
  height: number;
  data: ArrayLike<number>;
}

function pixelsOf(given: unknown): Pixels | undefined {
  // A face of a cube may itself be a data texture.
  const image = (
    (given as Partial<Texture> | null)?.isTexture ? (given as Texture).image : given
  ) as Partial<Pixels> | null;
  if (!image) return undefined;
  if (image.data && ArrayBuffer.isView(image.data)) return image as Pixels;
  if (typeof OffscreenCanvas === 'undefined') return undefined;
  try {
    const context = new OffscreenCanvas(WIDTH, HEIGHT).getContext('2d')!;
    context.drawImage(image as unknown as CanvasImageSource, 0, 0, WIDTH, HEIGHT);
    return context.getImageData(0, 0, WIDTH, HEIGHT);
  } catch {
    // The image is of another origin, or has not loaded.
    return undefined;
  }
}

const known = new WeakMap<Texture, { version: number; pixels: Luminances | undefined }>();

/** The luminances of a map, read once per version. */
function luminancesOf(map: Texture): Luminances | undefined {
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
  const pixels = map && map.channel === 0 && places ? luminancesOf(map) : undefined;
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
