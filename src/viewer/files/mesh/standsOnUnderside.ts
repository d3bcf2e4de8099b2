import { evenPoints } from '../../views/evenPoints.js';
import { mirrorPlanes } from '../../views/mirrorPlanes.js';
import { placeOf } from '../../views/planOf.js';
import { createSeenMap, drawSeenMap, NOTHING } from '../../views/seenMap.js';
import { viewSurface } from '../../views/viewSurface.js';
import { boundsOf } from './PlainMesh.js';
import type { UpAxis } from './UpAxis.js';

/** What touches the ground lies below this share of the height. */
const GROUND = 0.04;
/**
 * The least share of what is seen from below that touches the ground, which lying figures fall short of, and the largest, which only flat
 * backs exceed, such as those of what hangs on a wall.
 */
const SHARE = { least: 0.1, most: 0.6 };
/** The least clarity of the upright plane that mirrors the model; from an angle to it on, in degrees, others have less than a share of it. */
const MIRRORED = { clarity: 0.5, apart: 30, other: 0.8 };

/**
 * Whether a model would lie on an underside as bodies of vehicles, aeroplanes and animals have: uneven, yet broad, and below a body with
 * two like halves.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param up the axis that would point up
 */
export function standsOnUnderside(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  up: UpAxis,
): boolean {
  const surface = viewSurface({ positions, indices, isSingleSided: null }, up);
  const map = createSeenMap(surface);
  drawSeenMap(map, surface, 0, -90);
  const { low, high } = boundsOf(surface.positions);
  const ground = low[1] + GROUND * (high[1] - low[1]);
  let [seen, touching] = [0, 0];
  for (let pixel = 0; pixel < map.triangles.length; pixel++) {
    if (map.triangles[pixel] === NOTHING) continue;
    seen++;
    if (placeOf(map, pixel)[1] < ground) touching++;
  }
  if (touching < SHARE.least * seen || touching > SHARE.most * seen) return false;
  const { best, clarityAt } = mirrorPlanes(evenPoints(surface));
  if (clarityAt(best) < MIRRORED.clarity) return false;
  // What turning maps onto itself, as a vase or a star, has no underside of its own.
  for (let apart = MIRRORED.apart; apart <= 180 - MIRRORED.apart; apart += 5) {
    if (clarityAt((best + apart) % 180) >= MIRRORED.other * clarityAt(best)) return false;
  }
  return true;
}
