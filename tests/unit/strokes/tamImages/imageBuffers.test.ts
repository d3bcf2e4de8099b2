import { expect, it } from 'vitest';
import { imageBuffers } from '../../../../src/strokes/tamImages/HatchImages.js';

it('an image shared by two tones is transferred once, and stays shared', () => {
  const [paper, ink] = [255, 0].map((byte) => new Uint8Array(4).fill(byte));
  const images = [[paper], [ink], [ink]];
  const received = structuredClone(images, { transfer: imageBuffers({ size: 2, images }) });
  expect(received).toEqual([[255], [0], [0]].map((row) => row.map((byte) => new Uint8Array(4).fill(byte))));
});
