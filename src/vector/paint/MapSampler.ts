import type { MapLook, ToneImage, Wrapping } from './PaintLook.js';

/** A colour in linear light, with alpha. */
export type Rgba = [r: number, g: number, b: number, a: number];

/** An image with its mip levels. */
interface Pyramid {
  /** The image, followed by levels of half the size each, as far as they were needed. */
  levels: ToneImage[];
  /** The least and the greatest value of each channel. */
  least: Rgba;
  most: Rgba;
}

/** Pyramids by image, since surfaces share images. */
const pyramids = new WeakMap<ToneImage, Pyramid>();

function pyramidOf(image: ToneImage): Pyramid {
  const known = pyramids.get(image);
  if (known) return known;
  const pyramid: Pyramid = {
    levels: [image],
    least: [Infinity, Infinity, Infinity, Infinity],
    most: [-Infinity, -Infinity, -Infinity, -Infinity],
  };
  const { least, most } = pyramid;
  for (const [i, value] of image.data.entries()) {
    const k = i & 3;
    if (value < least[k]) least[k] = value;
    if (value > most[k]) most[k] = value;
  }
  pyramids.set(image, pyramid);
  return pyramid;
}

/** Samples a texture, averaged over a footprint. */
export class MapSampler {
  private readonly levels: ToneImage[];
  readonly least: Rgba;
  readonly most: Rgba;

  constructor(readonly look: MapLook) {
    const { levels, least, most } = pyramidOf(look.image);
    this.levels = levels;
    this.least = least;
    this.most = most;
  }

  /** The pixels of the image along a vector in texture coordinates. */
  pixelsAlong(u: number, v: number): readonly [number, number] {
    const { transform: m, image } = this.look;
    return [image.width * (m[0] * u + m[1] * v), image.height * (m[3] * u + m[4] * v)];
  }

  /** @param pixels width of the footprint in pixels of the image */
  read(u: number, v: number, pixels: number): Rgba {
    const { transform: m } = this.look;
    const [s, t] = [m[0] * u + m[1] * v + m[2], m[3] * u + m[4] * v + m[5]];
    const level = Math.max(Math.log2(pixels), 0);
    const whole = Math.floor(level);
    const fine = this.readLevel(whole, s, t);
    const share = level - whole;
    if (!(share > 0)) return fine;
    const coarse = this.readLevel(whole + 1, s, t);
    for (let k = 0; k < 4; k++) fine[k] += share * (coarse[k] - fine[k]);
    return fine;
  }

  private readLevel(level: number, s: number, t: number): Rgba {
    const { width, height, data } = this.levelOf(level);
    const { wrapU, wrapV, isSharp } = this.look;
    const [x, y] = [s * width - 0.5, t * height - 0.5];
    const at = (column: number, row: number): number =>
      4 * (wrapped(row, height, wrapV) * width + wrapped(column, width, wrapU));
    if (isSharp && level === 0) {
      const o = at(Math.round(x), Math.round(y));
      return [data[o], data[o + 1], data[o + 2], data[o + 3]];
    }
    const [left, below] = [Math.floor(x), Math.floor(y)];
    const [right, up] = [x - left, y - below];
    const corners = [at(left, below), at(left + 1, below), at(left, below + 1), at(left + 1, below + 1)];
    const mean = (k: number): number => {
      const low = data[corners[0] + k] + right * (data[corners[1] + k] - data[corners[0] + k]);
      const high = data[corners[2] + k] + right * (data[corners[3] + k] - data[corners[2] + k]);
      return low + up * (high - low);
    };
    return [mean(0), mean(1), mean(2), mean(3)];
  }

  private levelOf(level: number): ToneImage {
    const { levels } = this;
    while (levels.length <= level) {
      const last = levels[levels.length - 1];
      if (last.width === 1 && last.height === 1) return last;
      levels.push(halved(last));
    }
    return levels[level];
  }
}

/** The index of a pixel, wrapped if it lies beyond the edge. */
function wrapped(i: number, size: number, wrapping: Wrapping): number {
  if (!Number.isFinite(i)) return 0;
  if (wrapping === 'clamp') return Math.min(Math.max(i, 0), size - 1);
  if (wrapping === 'repeat') return ((i % size) + size) % size;
  const along = ((i % (2 * size)) + 2 * size) % (2 * size);
  return along < size ? along : 2 * size - 1 - along;
}

/** An image at half its size: each pixel is the mean of those that it covers. */
function halved({ width, height, data }: ToneImage): ToneImage {
  const [w, h] = [Math.max(1, width >> 1), Math.max(1, height >> 1)];
  const half = new Float32Array(4 * w * h);
  const [across, up] = [width > 1 ? 2 : 1, height > 1 ? 2 : 1];
  for (let i = 0; i < half.length; i++) {
    const [column, row] = [(i >> 2) % w, Math.floor((i >> 2) / w)];
    let sum = 0;
    for (let y = 0; y < up; y++)
      for (let x = 0; x < across; x++) sum += data[4 * ((up * row + y) * width + across * column + x) + (i & 3)];
    half[i] = sum / (across * up);
  }
  return { width: w, height: h, data: half };
}
