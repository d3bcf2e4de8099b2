import type { DecoderModule } from 'draco3d';

/** A decoded picture: an ImageBitmap in browsers, or RGBA pixels in rows from the top. */
export type DecodedPicture = ImageBitmap | PixelPicture;

/** A picture as RGBA bytes, for platforms without ImageBitmap. Has the members of ImageBitmap that are used here. */
export interface PixelPicture {
  readonly data: Uint8ClampedArray;
  readonly width: number;
  readonly height: number;
  /** Does nothing; ImageBitmap needs it. */
  close(): void;
}

/** Options for decoding a picture. */
export interface PictureWish {
  /** Target size in pixels. */
  width: number;
  height: number;
  /** Whether to flip the picture vertically. */
  flipY: boolean;
}

/** A picture to decode: a file, or the pixels of a format that browsers do not decode. */
export type PictureSource = Blob | Omit<PixelPicture, 'close'>;

/** Platform functions that the readers of models need: of a browser page, a worker or Node. */
export interface Surroundings {
  /**
   * Decodes a picture.
   *
   * @returns undefined if this platform cannot decode it; the platform reports that itself
   * @throws Error if it is damaged
   */
  decodePicture(source: PictureSource, wish: PictureWish): Promise<DecodedPicture | undefined>;
  /**
   * Loads the Draco decoder.
   *
   * @throws Error if it is not available
   */
  loadDraco(): Promise<DecoderModule>;
  /** Finds a file that was not passed along with the model, by the URI in the model. */
  findFile?: FindFile;
}

/** Returns the bytes of a dropped file by the URI that another file refers to, or undefined. */
export type FindFile = (uri: string) => Promise<Uint8Array | undefined>;

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
