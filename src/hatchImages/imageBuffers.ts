import type { HatchImages } from './HatchImages.js';

/** The buffers of hatch images, to be transferred with them: each once, though tones may share an image. */
export const imageBuffers = ({ images }: HatchImages): ArrayBuffer[] => [
  ...new Set(images.flatMap((levels) => levels.map(({ buffer }) => buffer as ArrayBuffer))),
];
