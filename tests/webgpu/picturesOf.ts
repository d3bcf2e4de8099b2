import type { Drawn } from './SceneCase.js';

/** Pixels per side of a picture. */
export const SIZE = 256;

/** An RGBA picture, its bottom row first. */
export type Pixels = Uint8Array;

/** The difference between a picture of nodes and that of GLSL. */
export interface Comparison {
  /** The share of pixels with a channel that differs by more than {@link NOTICEABLE}. */
  differing: number;
  /** The mean of all channels in GLSL and with nodes, from 0 to 255. */
  tones: [glsl: number, nodes: number];
  /** The share of pixels in GLSL that are not of the background. */
  covered: number;
  /** The number of colours in GLSL. */
  colours: number;
}

/** A noticeable difference of a channel, out of 255. */
export const NOTICEABLE = 8;

const channels = [0, 1, 2] as const;

function meanOf(pixels: Pixels): number {
  let sum = 0;
  for (let i = 0; i < pixels.length; i += 4) for (const channel of channels) sum += pixels[i + channel];
  return sum / (0.75 * pixels.length);
}

/** @param background the colour where no mesh is */
export function compare(glsl: Pixels, nodes: Pixels, background: readonly number[]): Comparison {
  if (nodes.length !== glsl.length) throw new Error('compare: the pictures have different sizes.');
  let differing = 0;
  let covered = 0;
  const colours = new Set<number>();
  for (let i = 0; i < glsl.length; i += 4) {
    if (channels.some((channel) => Math.abs(glsl[i + channel] - nodes[i + channel]) > NOTICEABLE)) differing++;
    if (channels.some((channel) => glsl[i + channel] !== background[channel])) covered++;
    colours.add((glsl[i] << 16) | (glsl[i + 1] << 8) | glsl[i + 2]);
  }
  const count = glsl.length / 4;
  return {
    differing: differing / count,
    tones: [meanOf(glsl), meanOf(nodes)],
    covered: covered / count,
    colours: colours.size,
  };
}

/** Rows of WebGPU's textures come from the top. */
export function fromBelow(pixels: Pixels, drawn: Drawn, size: number): Pixels {
  if (drawn !== 'webgpu') return pixels;
  const turned = new Uint8Array(pixels.length);
  for (let y = 0; y < size; y++) {
    turned.set(pixels.subarray(4 * size * y, 4 * size * (y + 1)), 4 * size * (size - 1 - y));
  }
  return turned;
}

/** Both pictures and their difference, side by side, as the data URL of a PNG. */
export function sideBySide(glsl: Pixels, nodes: Pixels): string {
  const canvas = document.createElement('canvas');
  canvas.width = 3 * SIZE;
  canvas.height = SIZE;
  const context = canvas.getContext('2d')!;
  const difference = glsl.map((value, i) => (i % 4 === 3 ? 255 : 255 - Math.min(255, 4 * Math.abs(value - nodes[i]))));
  for (const [i, pixels] of [glsl, nodes, difference].entries()) {
    const image = context.createImageData(SIZE, SIZE);
    for (let y = 0; y < SIZE; y++) {
      const from = 4 * SIZE * (SIZE - 1 - y);
      image.data.set(pixels.subarray(from, from + 4 * SIZE), 4 * SIZE * y);
    }
    for (let k = 3; k < image.data.length; k += 4) image.data[k] = 255;
    context.putImageData(image, i * SIZE, 0);
  }
  return canvas.toDataURL();
}
