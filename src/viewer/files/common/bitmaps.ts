import type { PictureSource, PictureWish, Surroundings } from './Surroundings.js';

/** Decodes a picture as browsers do, on a page or in a worker. */
async function decodeBitmap(source: PictureSource, { width, height, flipY }: PictureWish): Promise<ImageBitmap> {
  const content = source instanceof Blob ? source : new ImageData(new Uint8ClampedArray(source.data), source.width);
  return createImageBitmap(content, {
    resizeWidth: width,
    resizeHeight: height,
    resizeQuality: 'medium',
    // WebGL cannot flip a bitmap while uploading it.
    imageOrientation: flipY ? 'flipY' : 'none',
    // The shader reads pictures as numbers, which must not be converted. three's ImageBitmapLoader sets the same.
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
}

/** A browser without a decoder of Draco, whose address only a page knows. */
export const BITMAPS: Surroundings = {
  decodePicture: decodeBitmap,
  loadDraco: () => Promise.reject(new Error('There is no decoder of Draco.')),
};
