import type { HatchImages } from './HatchImages.js';

/** The buffers of hatch images, to be transferred with them. */
export const imageBuffers = ({ images }: HatchImages): ArrayBuffer[] =>
  images.flatMap((levels) => levels.map(({ buffer }) => buffer as ArrayBuffer));
