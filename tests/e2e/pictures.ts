import type { PNG } from 'pngjs';

/** A part of a picture, in shares of its width and height, from the top left. */
export interface Region {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export const WHOLE: Region = { left: 0, top: 0, right: 1, bottom: 1 };

const INK = [0x1c, 0x1a, 0x17].map(toLinear);
const PAPER = [0xf7, 0xf3, 0xe8].map(toLinear);

/**
 * The mean darkness of a region in linear light: 0 for bare paper, 1 for full ink. The background counts too, if the
 * region shows any.
 */
export function meanInk(picture: PNG, region: Region = WHOLE): number {
  let sum = 0;
  let count = 0;
  forEachPixel(picture, region, (offset) => {
    sum += darkness(picture, offset);
    count++;
  });
  return sum / count;
}

/**
 * The direction of the strokes, in degrees counter-clockwise from the horizontal, in [0, 180). It is perpendicular to
 * the strongest change, by the structure tensor of the region.
 */
export function strokeDirection(picture: PNG, region: Region): number {
  const { width } = picture;
  let xx = 0;
  let xy = 0;
  let yy = 0;
  forEachPixel(picture, region, (offset) => {
    const dx = darkness(picture, offset + 4) - darkness(picture, offset - 4);
    // Rows run downwards, y runs upwards.
    const dy = darkness(picture, offset - 4 * width) - darkness(picture, offset + 4 * width);
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  });
  const across = (Math.atan2(2 * xy, xx - yy) / 2) * (180 / Math.PI);
  return (across + 90 + 360) % 180;
}

/** The share of pixels in a region that are grey: neither nearly ink nor nearly paper. */
export function greyShare(picture: PNG, region: Region): number {
  let grey = 0;
  let count = 0;
  forEachPixel(picture, region, (offset) => {
    const value = darkness(picture, offset);
    if (value > 0.05 && value < 0.95) grey++;
    count++;
  });
  return grey / count;
}

/** Mean distance between edges of strokes, along rows and columns of a region, in pixels. */
export function edgeSpacing(picture: PNG, region: Region): number {
  const { width } = picture;
  let edges = 0;
  let count = 0;
  forEachPixel(picture, region, (offset) => {
    const isInk = darkness(picture, offset) > 0.5;
    if (darkness(picture, offset + 4) > 0.5 !== isInk) edges++;
    if (darkness(picture, offset + 4 * width) > 0.5 !== isInk) edges++;
    count += 2;
  });
  return count / edges;
}

/**
 * Correlation of the darkness of two pictures in a region: 1 for the same drawing, 0 for unrelated ones. The second may
 * be larger by a whole factor and is averaged down.
 */
export function likeness(picture: PNG, larger: PNG, region: Region): number {
  const factor = Math.round(larger.width / picture.width);
  const pairs: [number, number][] = [];
  forEachPixel(picture, region, (offset) => {
    const [x, y] = [(offset / 4) % picture.width, Math.floor(offset / 4 / picture.width)];
    let sum = 0;
    for (let j = 0; j < factor; j++) {
      for (let i = 0; i < factor; i++) sum += darkness(larger, 4 * ((y * factor + j) * larger.width + x * factor + i));
    }
    pairs.push([darkness(picture, offset), sum / factor ** 2]);
  });
  const mean = (k: 0 | 1): number => pairs.reduce((total, pair) => total + pair[k], 0) / pairs.length;
  const [meanA, meanB] = [mean(0), mean(1)];
  const covariance = (k: 0 | 1, l: 0 | 1): number => {
    const means = [meanA, meanB];
    return pairs.reduce((total, pair) => total + (pair[k] - means[k]) * (pair[l] - means[l]), 0);
  };
  return covariance(0, 1) / Math.sqrt(covariance(0, 0) * covariance(1, 1));
}

/** The leftmost ink of a row: where it starts, and how wide it is, in pixels. */
export function inkRun(picture: PNG, row: number): { start: number; width: number } {
  const isInk = (x: number): boolean => darkness(picture, 4 * (row * picture.width + x)) > 0.5;
  let start = 0;
  while (start < picture.width && !isInk(start)) start++;
  let end = start;
  while (end < picture.width && isInk(end)) end++;
  return { start, width: end - start };
}

/** The angle between two directions that have no sign, in [0, 90]. */
export function angleBetween(a: number, b: number): number {
  const difference = Math.abs(a - b) % 180;
  return Math.min(difference, 180 - difference);
}

/** The share of pixels that differ at all. */
export function changedShare(a: PNG, b: PNG): number {
  let changed = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    if (a.data.readUInt32LE(i) !== b.data.readUInt32LE(i)) changed++;
  }
  return changed / (a.data.length / 4);
}

/** The largest difference of any channel of any pixel, in [0, 255]. */
export function largestDifference(a: PNG, b: PNG): number {
  return a.data.reduce((largest, value, i) => Math.max(largest, Math.abs(value - b.data[i])), 0);
}

function forEachPixel(picture: PNG, region: Region, visit: (offset: number) => void): void {
  const { width, height } = picture;
  for (let y = Math.ceil(region.top * height); y < Math.floor(region.bottom * height); y++) {
    for (let x = Math.ceil(region.left * width); x < Math.floor(region.right * width); x++) visit(4 * (y * width + x));
  }
}

function darkness({ data }: PNG, offset: number): number {
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += (PAPER[k] - toLinear(data[offset + k])) / (PAPER[k] - INK[k]);
  return sum / 3;
}

function toLinear(value: number): number {
  const share = value / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}
