import { DataTexture, NearestFilter, RepeatWrapping } from 'three';
import { bayerRank, PERIOD, pointsOf, readStippleSet } from './stippleSet.js';

/** Texels per side: a cell knows by one more bit of its place whether it holds the point of the cell twice as large. */
export const STIPPLE_MAP_SIZE = 2 * PERIOD;

let stipple: DataTexture | undefined;

/**
 * The set of points of stipple, a texel per cell of half the size: red and green are its point within it; blue is when in an octave
 * it is born, 0 for one that was there before. Tiles. Made when first asked for, in some milliseconds; shared and never disposed of.
 */
export function stippleMap(): DataTexture {
  if (stipple === undefined) {
    stipple = new DataTexture(stippleTexels(), STIPPLE_MAP_SIZE, STIPPLE_MAP_SIZE);
    stipple.wrapS = stipple.wrapT = RepeatWrapping;
    stipple.magFilter = stipple.minFilter = NearestFilter;
    stipple.needsUpdate = true;
  }
  return stipple;
}

function stippleTexels(): Uint8Array {
  const texels = new Uint8Array(4 * STIPPLE_MAP_SIZE ** 2);
  const { quarters, births } = readStippleSet();
  const points = pointsOf(quarters);
  for (let cell = 0; cell < PERIOD ** 2; cell++) {
    const [left, below] = [2 * (cell % PERIOD), 2 * Math.floor(cell / PERIOD)];
    for (const [place, b] of [quarters[cell], ...births[cell]].entries()) {
      const [x, y] = [left + (b & 1), below + (b >> 1)];
      const point = 2 * ((y % PERIOD) * PERIOD + (x % PERIOD));
      // A third of the octave for each of the three, and its parts evenly over the plane.
      const born = (place - 1 + (bayerRank(cell) + 0.5) / PERIOD ** 2) / 3;
      texels.set(
        [255 * points[point], 255 * points[point + 1], place === 0 ? 0 : Math.max(1, 255 * born), 255].map(Math.round),
        4 * (y * STIPPLE_MAP_SIZE + x),
      );
    }
  }
  return texels;
}
