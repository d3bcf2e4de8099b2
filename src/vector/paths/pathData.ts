import type { Ring } from './strokeOutline.js';

/** Coordinates are written in hundredths of a millimetre. */
const PER_MILLIMETRE = 100;

/** The placement of a picture on its sheet. */
export interface Placement {
  /** Millimetres per pixel. */
  scale: number;
  /** The upper left corner of the picture, millimetres. */
  left: number;
  top: number;
}

/** A number of hundredths, in its shortest form. */
function written(hundredths: number): string {
  const text = (hundredths / PER_MILLIMETRE).toFixed(2).replace(/\.?0+$/, '');
  return text.replace(/^(-?)0\./, '$1.') || '0';
}

/** The path data of a polyline; empty if all points are at one place. */
export function pathData(xy: Ring, isClosed: boolean, { scale, left, top }: Placement): string {
  const at = (i: number): readonly [number, number] => [
    Math.round((left + scale * xy[2 * i]) * PER_MILLIMETRE),
    Math.round((top + scale * xy[2 * i + 1]) * PER_MILLIMETRE),
  ];
  if (xy.length < 4) return '';
  let [x, y] = at(0);
  const first = `M${written(x)} ${written(y)}`;
  let steps = '';
  for (let i = 1; 2 * i < xy.length; i++) {
    const [nextX, nextY] = at(i);
    if (nextX === x && nextY === y) continue;
    const [dx, dy] = [written(nextX - x), written(nextY - y)];
    // A minus sign needs no space before it.
    steps += `${steps === '' ? 'l' : dx.startsWith('-') ? '' : ' '}${dx}${dy.startsWith('-') ? '' : ' '}${dy}`;
    [x, y] = [nextX, nextY];
  }
  return steps === '' ? '' : `${first}${steps}${isClosed ? 'z' : ''}`;
}
