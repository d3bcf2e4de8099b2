import type { HatchImages } from './HatchImages.js';

/** The buffers of hatch images, which are transferred with them. Each is listed once, even if tones share an image. */
export const imageBuffers = ({ images }: HatchImages): ArrayBuffer[] => [
  ...new Set(images.flatMap((levels) => levels.map(({ buffer }) => buffer as ArrayBuffer))),
];
