import type { DecoderModule } from 'draco3d';
import type { FindFile } from './FindFile.js';

/** A picture, decoded: a bitmap of the browser, or its pixels, as RGBA in rows from above. */
export type DecodedPicture = ImageBitmap | PixelPicture;

/** A picture as plain numbers, where there are no bitmaps. It has what is used of a bitmap. */
export interface PixelPicture {
  readonly data: Uint8ClampedArray;
  readonly width: number;
  readonly height: number;
  /** Does nothing, as there is nothing to give back. */
  close(): void;
}

/** How a picture is decoded. */
export interface PictureWish {
  /** The size to decode it in, in pixels. */
  width: number;
  height: number;
  /** Whether it is turned over. */
  flipY: boolean;
}

/** A picture to be decoded: a file, or its pixels, of a format that no browser decodes. */
export type PictureSource = Blob | Omit<PixelPicture, 'close'>;

/** What readers of models ask of where they run. */
export interface Surroundings {
  /**
   * Decodes a picture.
   *
   * @returns undefined if it cannot be decoded here, which the reader leaves to its surroundings to tell
   * @throws Error if it is damaged
   */
  decodePicture(source: PictureSource, wish: PictureWish): Promise<DecodedPicture | undefined>;
  /**
   * Draco's decoder.
   *
   * @throws Error if there is none
   */
  loadDraco(): Promise<DecoderModule>;
  /** Finds a file that was not handed over with the model, by the URI that the model refers to it with. */
  findFile?: FindFile;
}
