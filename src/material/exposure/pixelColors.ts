import type { Texture } from 'three';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { decoderOf } from '../readImage.js';
import type { SurfaceSamples } from './surfaceSamples.js';

/** The colours of an image's pixels in linear light, from the first row of the file. */
export interface PixelColors {
  width: number;
  height: number;
  /** A number of a pixel: 0 for red, 1 for green, 2 for blue. */
  at(column: number, row: number, channel: number): number;
}

/** The width to which images of the browser are scaled before they are read. */
const WIDTH = 256;
const HEIGHT = 128;

/** The colours of a texture's image, if this thread can read it. */
export function pixelColors(image: unknown, texture: Texture): PixelColors | undefined {
  const { width, height, data } = pixelsOf(image) ?? {};
  if (!width || !height || !data) return undefined;
  const channels = data.length / (width * height);
  const decode = decoderOf(texture, data);
  const at = (column: number, row: number, channel: number): number => {
    const k = channels < 3 ? 0 : channel;
    return decode(channels * (row * width + column) + k, k);
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

const known = new WeakMap<Texture, { version: number; pixels: PixelColors | undefined }>();

/** The colours of a map, read once per version. */
function colorsOf(map: Texture): PixelColors | undefined {
  const before = known.get(map);
  if (before?.version === map.version) return before.pixels;
  const pixels = pixelColors(map.image, map);
  known.set(map, { version: map.version, pixels });
  return pixels;
}

/**
 * Writes the colour of a surface at its samples: from its material, its vertices and its map. A map that cannot be read here, or uses
 * texture coordinates other than the first, counts as white.
 */
export function colorWriter(
  { color, vertexColors, map }: HatchingMaterialProperties,
  { colors, places }: SurfaceSamples,
): (sample: number, into: Float64Array) => void {
  const own = [color.r, color.g, color.b];
  const painted = vertexColors ? colors : undefined;
  const pixels = map && map.channel === 0 && places ? colorsOf(map) : undefined;
  if (map?.matrixAutoUpdate) map.updateMatrix();
  return (sample, into) => {
    for (let k = 0; k < 3; k++) into[k] = own[k] * (painted?.[3 * sample + k] ?? 1);
    if (!pixels || !map || !places) return;
    const e = map.matrix.elements;
    const [u, v] = [places[2 * sample], places[2 * sample + 1]];
    const across = fraction(e[0] * u + e[3] * v + e[6]);
    const up = fraction(e[1] * u + e[4] * v + e[7]);
    const column = Math.min(pixels.width - 1, Math.floor(across * pixels.width));
    const row = Math.min(pixels.height - 1, Math.floor((map.flipY ? 1 - up : up) * pixels.height));
    for (let k = 0; k < 3; k++) into[k] *= pixels.at(column, row, k);
  };
}

const fraction = (value: number): number => value - Math.floor(value);
