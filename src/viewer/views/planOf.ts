import { boundsOf } from '../files/mesh/PlainMesh.js';
import { createSeenMap, drawSeenMap, MAP_SIZE, NOTHING, type SeenMap } from './seenMap.js';
import type { ViewSurface } from './viewSurface.js';

/** What is seen of a surface from above: the height of each pixel as a share of the surface's height. */
export interface Plan {
  /** Within the border. */
  within: number[];
  /** Along the outline. */
  rim: number[];
  /** The number of pixels that the surface covers. */
  covered: number;
}

/** The border of a plan that walls may fill, as a share of its width. */
const BORDER = 0.08;
/** A floor lies below this share of the height, and is seen in at least this share of the plan. */
const FLOOR = { below: 0.25, cover: 0.4 };
/** What stands on a floor rises this share of the height above it, on at least this share of the plan. */
const CONTENT = { rise: 0.06, cover: 0.02 };
/** Walls reach above this share of the height, along at least this share of the outline. */
const WALLS = { above: 0.6, share: 0.6 };

/** Looks at a surface from above. */
export function planOf(surface: ViewSurface): Plan {
  const map = createSeenMap(surface);
  drawSeenMap(map, surface, 0, 90);
  const isWithin = withinBorder(surface);
  const { low, high } = boundsOf(surface.positions);
  const plan: Plan = { within: [], rim: [], covered: 0 };
  for (let pixel = 0; pixel < map.triangles.length; pixel++) {
    if (map.triangles[pixel] === NOTHING) continue;
    plan.covered++;
    const place = placeOf(map, pixel);
    const height = (place[1] - low[1]) / (high[1] - low[1]);
    if (isWithin(place)) plan.within.push(height);
    const isOuter = [1, -1, MAP_SIZE, -MAP_SIZE].some((step) => (map.triangles[pixel + step] ?? NOTHING) === NOTHING);
    if (isOuter) plan.rim.push(height);
  }
  return plan;
}

/** Whether a plan shows a floor with walls around it, or with things that stand on it. */
export function showsFloor({ within, covered }: Plan): boolean {
  const floors = floorsIn(within);
  const standing = within.filter((height) => height > floors[floors.length >> 1] + CONTENT.rise);
  return floors.length > FLOOR.cover * covered && standing.length > CONTENT.cover * covered;
}

/** Whether a plan shows a floor with walls around it. */
export function isWalled({ within, rim, covered }: Plan): boolean {
  const walls = rim.filter((height) => height > WALLS.above);
  return floorsIn(within).length > FLOOR.cover * covered && walls.length > WALLS.share * rim.length;
}

/** The lowest heights, in rising order. */
const floorsIn = (heights: readonly number[]): number[] =>
  heights.filter((height) => height < FLOOR.below).sort((a, b) => a - b);

/** A function that tells whether a place lies within the border of a surface's plan. */
export function withinBorder({ positions }: ViewSurface): (place: readonly number[]) => boolean {
  const { low, high } = boundsOf(positions);
  const border = BORDER * Math.min(high[0] - low[0], high[2] - low[2]);
  return (place) => [0, 2].every((k) => place[k] > low[k] + border && place[k] < high[k] - border);
}

/** The place in the unit sphere of what a pixel of a map shows. */
export function placeOf({ right, up, towards, nearness }: SeenMap, pixel: number): [x: number, y: number, z: number] {
  const unit = 2 / MAP_SIZE;
  const across = ((pixel % MAP_SIZE) + 0.5) * unit - 1;
  const along = (Math.floor(pixel / MAP_SIZE) + 0.5) * unit - 1;
  const near = nearness[pixel] * unit;
  const at = (k: 0 | 1 | 2): number => across * right[k] + along * up[k] + near * towards[k];
  return [at(0), at(1), at(2)];
}
