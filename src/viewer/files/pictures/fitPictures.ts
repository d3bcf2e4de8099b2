/** The maximum number of pixels of one picture: a file of 44 kilobytes can decode to a gigabyte. */
const MAX_PIXELS = 2 ** 26;
/** The maximum number of pixels of all pictures of a model at file size. They are decoded one at a time. */
const MAX_TOTAL_PIXELS = 2 ** 28;
/** The maximum number of pixels of all pictures as drawn: eight of 2,048 pixels square take 171 megabytes with their mipmaps. */
const MAX_DRAWN_PIXELS = 2 ** 25;
const MAX_DRAWN_SIDE = 4096;

/** The size of a picture: of the file, and after {@link fitPictures} the size to draw it in. */
export interface PictureSize {
  width: number;
  height: number;
  /** Whether it is drawn smaller than in the file. */
  isReduced: boolean;
}

/** Adds up pixels of pictures, and checks whether another may be decoded. */
export class PixelBudget {
  private total = 0;

  /** Counts a picture. @returns whether it is within the limits */
  take(width: number, height: number): boolean {
    const pixels = width * height;
    if (pixels > MAX_PIXELS || this.total + pixels > MAX_TOTAL_PIXELS) return false;
    this.total += pixels;
    return true;
  }
}

/** Reduces the sizes of pictures until they fit together. @returns notes for the caption, if any was reduced */
export function fitPictures(pictures: readonly PictureSize[]): string[] {
  const given = pictures.map((picture) => ({ picture, ...picture }));
  for (let side = MAX_DRAWN_SIDE; ; side /= 2) {
    let total = 0;
    for (const { picture, width, height } of given) {
      const factor = Math.min(1, side / Math.max(width, height));
      picture.width = Math.max(1, Math.round(factor * width));
      picture.height = Math.max(1, Math.round(factor * height));
      picture.isReduced = factor < 1;
      total += picture.width * picture.height;
    }
    if (total > MAX_DRAWN_PIXELS && side > 1) continue;
    const isReduced = given.some(({ picture }) => picture.isReduced);
    return isReduced ? [`pictures reduced to ${side.toLocaleString('en')} pixels`] : [];
  }
}
