import type { PictureSource, PictureWish, Surroundings } from './Surroundings.js';

/** Decodes a picture with the browser's decoder, on a page or in a worker. */
async function decodeBitmap(source: PictureSource, { width, height, flipY }: PictureWish): Promise<ImageBitmap> {
  const content = source instanceof Blob ? source : new ImageData(new Uint8ClampedArray(source.data), source.width);
  return createImageBitmap(content, {
    resizeWidth: width,
    resizeHeight: height,
    resizeQuality: 'medium',
    // WebGL cannot flip a bitmap while uploading it.
    imageOrientation: flipY ? 'flipY' : 'none',
    // Shaders need the stored values without conversion. three's ImageBitmapLoader uses the same options.
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
}

/** The platform functions of browsers, without Draco, since only a page knows its URL. */
export const BITMAPS: Surroundings = {
  decodePicture: decodeBitmap,
  loadDraco: () => Promise.reject(new Error('There is no decoder of Draco.')),
};
