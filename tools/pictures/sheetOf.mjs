import { PNG } from 'pngjs';

/**
 * Drawings side by side, in rows.
 *
 * @param {readonly PNG[]} drawings all of one size
 * @param {number} columns
 */
export function sheetOf(drawings, columns) {
  const { width, height } = drawings[0];
  const sheet = new PNG({ width: columns * width, height: Math.ceil(drawings.length / columns) * height });
  drawings.forEach((drawing, i) => {
    PNG.bitblt(drawing, sheet, 0, 0, width, height, (i % columns) * width, Math.floor(i / columns) * height);
  });
  return sheet;
}
