import { DataTexture, NearestFilter, RepeatWrapping } from 'three';
import { STIPPLE_MAP_SIZE, STIPPLE_PERIOD } from './patternSizes.js';
import { bayerRank, pointsOf, readStippleSet } from './stippleSet.js';

let stipple: DataTexture | undefined;

/**
 * The set of points for stippling, with a texel per quarter of a cell. Red and green hold the position of the quarter's point within
 * it; blue holds the moment at which the point appears in an octave of magnification, 0 if it was there before. The texture tiles. The
 * first call makes it in a few milliseconds; it is shared and never disposed of.
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
  for (let cell = 0; cell < STIPPLE_PERIOD ** 2; cell++) {
    const [left, below] = [2 * (cell % STIPPLE_PERIOD), 2 * Math.floor(cell / STIPPLE_PERIOD)];
    for (const [place, b] of [quarters[cell], ...births[cell]].entries()) {
      const [x, y] = [left + (b & 1), below + (b >> 1)];
      const point = 2 * ((y % STIPPLE_PERIOD) * STIPPLE_PERIOD + (x % STIPPLE_PERIOD));
      // Each of the three new points of a cell appears in its own third of the octave, evenly distributed over the plane.
      const born = (place - 1 + (bayerRank(cell) + 0.5) / STIPPLE_PERIOD ** 2) / 3;
      texels.set(
        [255 * points[point], 255 * points[point + 1], place === 0 ? 0 : Math.max(1, 255 * born), 255].map(Math.round),
        4 * (y * STIPPLE_MAP_SIZE + x),
      );
    }
  }
  return texels;
}
