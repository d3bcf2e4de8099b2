import { areaOf, boundsOf } from './PlainMesh.js';
import { standsOnFeet } from './standsOnFeet.js';
import { standsOnUnderside } from './standsOnUnderside.js';
import type { UpAxis } from './UpAxis.js';

const AXES = ['x', 'y', 'z'] as const;
/** The maximum distance of a triangle on a flat side from the outermost plane, as a share of the model's extent. */
const FLATNESS = 0.004;
/** A model may stand on a side if this share of it is flat, and its flat area is this many times that of any perpendicular side. */
const STAND_SHARE = 0.25;
const DISTINCTNESS = 3;
/** A model that would be lower than this share of its width may be a relief or a board that hangs on a wall. */
const LOWEST = 0.4;
/** So may one that would be lower than the first share, if it is higher than the second share of its width as it is. */
const HANGING = { lowest: 0.6, upright: 0.95 };
/** A model that would be lower than this share of its length and of its width is a door or a railing that stands upright. */
const UPRIGHT = 0.2;
/** A model that is thinner than this share of its length and width is a plate, even though its edges are flat too. */
const PLATE = 0.25;

/** The usual orientation of a format's models. */
export interface UsualUp {
  /** The usual up axis. */
  up: 'y' | 'z';
  /** Whether models lie flat on a printer bed, so that none hangs on a wall or stands on its edge. */
  liesFlat: boolean;
}

/** An up axis, and what a model then stands on. */
export interface Standing {
  up: UpAxis;
  on: 'feet' | 'flat side' | 'underside';
}

/**
 * Finds the up axis of a model by the feet, the flat side or the underside that it stands on. A model that stands firmly as it is, such
 * as a vehicle on its wheels, stays so, however flat another side is.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @returns undefined if it stands firmly, or if nothing tells the axis clearly
 */
export function findUpAxis(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  usual: UsualUp,
): Standing | undefined {
  const { low, high } = boundsOf(positions);
  const size = AXES.map((_, axis) => high[axis] - low[axis]);
  const tolerance = FLATNESS * Math.max(...size);
  const sides = outerSides(positions, low, high, tolerance);
  // Only printers' files are on their side; elsewhere posts at the end of a bed are no feet.
  const onFeet = axisOfFeet(
    (side, axis) => (axis > 0 || usual.liesFlat) && standsOnFeet(positions, indices, sides, side, axis, size),
  );
  if (onFeet === usual.up) return undefined;
  if (onFeet && !wouldLie(size, onFeet)) return { up: onFeet, on: 'feet' };
  if (standsFirmly(positions, indices, usual.up)) return undefined;
  const onSide = axisOfSide(positions, indices, sides, size, usual);
  if (onSide) return { up: onSide, on: 'flat side' };
  // Printers' files have few vehicles, and undersides of all kinds.
  if (usual.liesFlat || !standsFirmly(positions, indices, OTHER[usual.up])) return undefined;
  if (wouldLie(size, OTHER[usual.up]) || !standsOnUnderside(positions, indices, OTHER[usual.up])) return undefined;
  return { up: OTHER[usual.up], on: 'underside' };
}

/** Whether a model is a plate that would lie flat with an axis up. */
function wouldLie(size: readonly number[], up: UpAxis): boolean {
  const height = AXES.findIndex((axis) => up.endsWith(axis));
  return size[height] < UPRIGHT * Math.min(...size.filter((_, axis) => axis !== height));
}

/** Whether a model that would be low with an axis up may hang on a wall. @param up the axis @param usual the usual one of its format */
function mayHang(size: readonly number[], up: number, usual: number): boolean {
  const width = Math.max(...size.filter((_, axis) => axis !== up));
  const isUpright = up !== usual && size[usual] > HANGING.upright * size[3 - up - usual];
  return size[up] < (isUpright ? HANGING.lowest : LOWEST) * width;
}

/** The up axis of the other half of all programs. */
const OTHER = { y: 'z', z: 'y' } as const;

/**
 * The axis that points up from a flat side.
 *
 * @param sides for each vertex the bits of the model's sides that it lies on
 * @param size of the model along each axis
 * @returns undefined if no side is flat, or if more than one pair of sides is, which leaves the axis open
 */
function axisOfSide(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  sides: Uint8Array,
  size: readonly number[],
  usual: UsualUp,
): UpAxis | undefined {
  const { liesFlat } = usual;
  /** The area on the lower and on the upper side across each axis. */
  const areas = AXES.map(() => [0, 0] as [number, number]);
  const corners = indices?.length ?? positions.length / 3;
  for (let corner = 0; corner + 2 < corners; corner += 3) {
    const a = 3 * (indices ? indices[corner] : corner);
    const b = 3 * (indices ? indices[corner + 1] : corner + 1);
    const c = 3 * (indices ? indices[corner + 2] : corner + 2);
    const side = sides[a / 3] & sides[b / 3] & sides[c / 3];
    // Most triangles lie on no side and need no area.
    if (side === 0) continue;
    for (let axis = 0; axis < 3; axis++) {
      const ofAxis = (side >> (2 * axis)) & 3;
      if (ofAxis === 0) continue;
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const from = (at: number, across: number): number => positions[at + across] - positions[a + across];
      const area = from(b, u) * from(c, v) - from(c, u) * from(b, v);
      areas[axis][ofAxis & 1 ? 0 : 1] += Math.abs(area) / 2;
    }
  }
  const across = (axis: number): number => size[(axis + 1) % 3] * size[(axis + 2) % 3];
  const shares = areas.map((pair, axis) => (across(axis) > 0 ? Math.max(...pair) / across(axis) : 0));
  const [thinnest, next] = [0, 1, 2].sort((a, b) => size[a] - size[b]);
  const isPlate = liesFlat && size[thinnest] < PLATE * size[next];
  const best = isPlate ? thinnest : shares.indexOf(Math.max(...shares));
  if (shares[best] < STAND_SHARE) return undefined;
  if (!isPlate) {
    const others = shares.filter((_, axis) => axis !== best);
    if (shares[best] < DISTINCTNESS * Math.max(...others)) return undefined;
    if (!liesFlat && mayHang(size, best, AXES.indexOf(usual.up))) return undefined;
  }
  // Only printers' files are often upside down or on their side.
  if (!liesFlat) return best === 0 ? undefined : AXES[best];
  const [below, above] = areas[best];
  // A column has two pairs of flat sides and keeps its axis.
  return above > 1.1 * below ? `-${AXES[best]}` : AXES[best];
}

/** Map coordinates are this many times the size of a model away, and heights at most this share as far as they are. */
const MAP = { away: 100, height: 0.02 };

/**
 * The up axis of a model at map coordinates: two of them are far away, and the third is the height above the sea.
 *
 * @param offset of the model from the origin, in sizes of the model
 * @returns undefined if it is not at such coordinates
 */
export function upOnMap(offset: readonly number[]): 'y' | 'z' | undefined {
  const [x, y, z] = offset.map(Math.abs);
  const isHeight = (height: number, other: number): boolean =>
    Math.min(x, other) > MAP.away && height < MAP.height * Math.min(x, other);
  if (isHeight(z, y)) return 'z';
  return isHeight(y, z) ? 'y' : undefined;
}

/** The axis that points up from the feet of a model. Where both ends look like feet, as posts of a shelf do, it is the positive one. */
function axisOfFeet(isOnFeet: (side: number, axis: number) => boolean): UpAxis | undefined {
  const found = AXES.flatMap((name, axis): UpAxis[] => {
    if (isOnFeet(LOWER << (2 * axis), axis)) return [name];
    return isOnFeet(UPPER << (2 * axis), axis) ? [`-${name}`] : [];
  });
  return found.length === 1 ? found[0] : undefined;
}

/** The bits of the two sides across the first axis; those of the next axes follow. */
const LOWER = 1;
const UPPER = 2;

/** For each vertex, the sides of the model it lies on: two bits per axis. */
function outerSides(
  positions: ArrayLike<number>,
  low: readonly number[],
  high: readonly number[],
  tolerance: number,
): Uint8Array {
  const sides = new Uint8Array(positions.length / 3);
  for (let axis = 0; axis < 3; axis++) {
    const lower = low[axis] + tolerance;
    const upper = high[axis] - tolerance;
    for (let vertex = 0; vertex < sides.length; vertex++) {
      const at = positions[3 * vertex + axis];
      if (at < lower) sides[vertex] |= LOWER << (2 * axis);
      if (at > upper) sides[vertex] |= UPPER << (2 * axis);
    }
  }
  return sides;
}

/** The maximum height of a contact vertex above the lowest point, as a share of the model's extent. */
const CONTACT = 0.005;
/** The slope of the tilt, 12 degrees in any direction, that a firmly standing model must survive. */
const TILT = Math.tan((12 * Math.PI) / 180);
/** Larger meshes are sampled by this many triangles, enough to find the centre. */
const SAMPLED_TRIANGLES = 250_000;
/** The directions of tilting. */
const DIRECTIONS = Array.from({ length: 24 }, (_, i) => {
  const angle = (2 * Math.PI * i) / 24;
  return { cos: Math.cos(angle), sin: Math.sin(angle) };
});

/**
 * Whether a hollow model of one material would stay standing on level ground, on wheels or feet as well as on a flat side.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param up the axis that points up
 */
function standsFirmly(positions: ArrayLike<number>, indices: ArrayLike<number> | null, up: 'y' | 'z'): boolean {
  const height = up === 'y' ? 1 : 2;
  const [u, v] = [(height + 1) % 3, (height + 2) % 3];
  const { low, high } = boundsOf(positions);
  const lowest = low[height];
  const extent = Math.max(...high.map((value, axis) => value - low[axis]));
  const centre = centreOfArea(positions, indices);
  /** How far contact vertices reach in each direction from the point below the centre. */
  const reach = DIRECTIONS.map(() => -Infinity);
  const contact = CONTACT * extent;
  for (let i = 0; i < positions.length; i += 3) {
    if (positions[i + height] - lowest > contact) continue;
    const x = positions[i + u] - centre[u];
    const y = positions[i + v] - centre[v];
    // A plain loop for speed: large models have many contact vertices.
    for (let k = 0; k < DIRECTIONS.length; k++) {
      const { cos, sin } = DIRECTIONS[k];
      reach[k] = Math.max(reach[k], cos * x + sin * y);
    }
  }
  return Math.min(...reach) > TILT * (centre[height] - lowest);
}

/** The area-weighted centre of the triangles. */
function centreOfArea(positions: ArrayLike<number>, indices: ArrayLike<number> | null): number[] {
  let [x, y, z, total] = [0, 0, 0, 0];
  const count = indices?.length ?? positions.length / 3;
  const step = 3 * Math.ceil(count / 3 / SAMPLED_TRIANGLES);
  for (let corner = 0; corner + 2 < count; corner += step) {
    const a = 3 * (indices ? indices[corner] : corner);
    const b = 3 * (indices ? indices[corner + 1] : corner + 1);
    const c = 3 * (indices ? indices[corner + 2] : corner + 2);
    const area = areaOf(positions, a, b, c);
    total += area;
    x += area * (positions[a] + positions[b] + positions[c]);
    y += area * (positions[a + 1] + positions[b + 1] + positions[c + 1]);
    z += area * (positions[a + 2] + positions[b + 2] + positions[c + 2]);
  }
  return [x, y, z].map((sum) => sum / (3 * total));
}
