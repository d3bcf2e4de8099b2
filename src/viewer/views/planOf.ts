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

/** Looks at a surface from above. @param map of the surface, which is drawn anew */
export function planOf(surface: ViewSurface, map = createSeenMap(surface)): Plan {
  drawSeenMap(map, surface, 0, 90);
  const isWithin = withinBorder(surface);
  const { low, high } = boundsOf(surface.positions);
  const plan: Plan = { within: [], rim: [], covered: 0 };
  for (let row = 0; row < MAP_SIZE; row++) addRow(plan, map, row, isWithin, low[1], high[1] - low[1]);
  return plan;
}

function addRow(
  plan: Plan,
  { triangles, nearness }: SeenMap,
  row: number,
  isWithin: (x: number, z: number) => boolean,
  lowest: number,
  size: number,
): void {
  for (let pixel = row * MAP_SIZE; pixel < (row + 1) * MAP_SIZE; pixel++) {
    if (triangles[pixel] === NOTHING) continue;
    plan.covered++;
    const height = (UNIT * nearness[pixel] - lowest) / size;
    if (isWithin(middleOf(pixel % MAP_SIZE), -middleOf(row))) plan.within.push(height);
    // A pixel beyond the first or the last is none, and counts as empty.
    const isInner =
      triangles[pixel - 1] >= 0 &&
      triangles[pixel + 1] >= 0 &&
      triangles[pixel - MAP_SIZE] >= 0 &&
      triangles[pixel + MAP_SIZE] >= 0;
    if (!isInner) plan.rim.push(height);
  }
}

/** Whether a plan shows a floor with walls around it, or with things that stand on it. */
export function showsFloor({ within, covered }: Plan): boolean {
  const floors = floorsIn(within).sort((a, b) => a - b);
  const standing = within.filter((height) => height > floors[floors.length >> 1] + CONTENT.rise);
  return floors.length > FLOOR.cover * covered && standing.length > CONTENT.cover * covered;
}

/** Whether a plan shows a floor with walls around it. */
export function isWalled({ within, rim, covered }: Plan): boolean {
  const walls = rim.filter((height) => height > WALLS.above);
  return floorsIn(within).length > FLOOR.cover * covered && walls.length > WALLS.share * rim.length;
}

/** The lowest heights. */
const floorsIn = (heights: readonly number[]): number[] => heights.filter((height) => height < FLOOR.below);

/** A function that tells whether a place lies within the border of a surface's plan. */
export function withinBorder({ positions }: ViewSurface): (x: number, z: number) => boolean {
  const { low, high } = boundsOf(positions);
  const border = BORDER * Math.min(high[0] - low[0], high[2] - low[2]);
  const [left, right] = [low[0] + border, high[0] - border];
  const [far, near] = [low[2] + border, high[2] - border];
  return (x, z) => x > left && x < right && z > far && z < near;
}

/** The size of a pixel, in radii, and the middle of a row or a column. */
const UNIT = 2 / MAP_SIZE;
const middleOf = (line: number): number => (line + 0.5) * UNIT - 1;

/** The place in the unit sphere of what a pixel of a map shows. */
export function placeOf({ right, up, towards, nearness }: SeenMap, pixel: number): [x: number, y: number, z: number] {
  const across = middleOf(pixel % MAP_SIZE);
  const along = middleOf(Math.floor(pixel / MAP_SIZE));
  const near = nearness[pixel] * UNIT;
  const at = (k: 0 | 1 | 2): number => across * right[k] + along * up[k] + near * towards[k];
  return [at(0), at(1), at(2)];
}
