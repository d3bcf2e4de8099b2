import type { PictureWish, PixelPicture } from '../../viewer/files/common/Surroundings.js';

/** A picture in the size that is wished for, each pixel the mean of those in its place, and turned over if that is wished for. */
export function fitPixels(picture: Omit<PixelPicture, 'close'>, { width, height, flipY }: PictureWish): PixelPicture {
  const isFitting = picture.width === width && picture.height === height && !flipY;
  const data = isFitting ? picture.data : new Uint8ClampedArray(4 * width * height);
  for (let y = 0; !isFitting && y < height; y++) {
    const row = flipY ? height - 1 - y : y;
    const [top, bottom] = span(row, height, picture.height);
    for (let x = 0; x < width; x++) {
      const [left, right] = span(x, width, picture.width);
      const sums = [0, 0, 0, 0];
      for (let j = top; j < bottom; j++) {
        for (let i = left; i < right; i++)
          for (let k = 0; k < 4; k++) sums[k] += picture.data[4 * (j * picture.width + i) + k];
      }
      const count = (bottom - top) * (right - left);
      for (let k = 0; k < 4; k++) data[4 * (y * width + x) + k] = sums[k] / count;
    }
  }
  return { data, width, height, close: () => {} };
}

/** The places from which one of `count` is made, of `given`: the first, and the one after the last. */
function span(place: number, count: number, given: number): [number, number] {
  const from = Math.floor((place * given) / count);
  return [from, Math.max(from + 1, Math.floor(((place + 1) * given) / count))];
}
