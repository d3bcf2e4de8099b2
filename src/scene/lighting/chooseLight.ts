import type { SeenSurface } from './seenSurface.js';

type Vector = readonly [x: number, y: number, z: number];

/** An object that casts a shadow on level ground, and its view by a camera. */
interface Standing {
  /** x, y, z of points of the object in world space: enough of them to tell its extent. */
  points: ArrayLike<number>;
  /** The unit vector upwards. The ground goes through the lowest point. */
  top: Vector;
  /** The matrix from world space to the sheet, in the column order of `Matrix4.elements`. */
  toSheet: ArrayLike<number>;
}

/**
 * The reach of an object's shadow on the ground, from the middle of the sheet towards its edges: up to 1 the shadow lies wholly on the
 * sheet. Infinity under a light at the horizon or below, and for a shadow that reaches behind the eye.
 *
 * @param direction unit vector to a distant light
 */
export function shadowReach({ points, top, toSheet }: Standing, direction: Vector): number {
  const climb = dot(direction, top);
  if (!(climb > 0)) return Infinity;
  const [east, up, south] = direction.map((part) => part / climb);
  const ground = lowest(points, top);
  let reach = 0;
  for (let i = 0; i < points.length; i += 3) {
    const height = points[i] * top[0] + points[i + 1] * top[1] + points[i + 2] * top[2] - ground;
    const place: Vector = [points[i] - height * east, points[i + 1] - height * up, points[i + 2] - height * south];
    reach = Math.max(reach, placeReach(place, toSheet));
  }
  return reach;
}

function lowest(points: ArrayLike<number>, top: Vector): number {
  let least = Infinity;
  for (let i = 0; i < points.length; i += 3) {
    least = Math.min(least, points[i] * top[0] + points[i + 1] * top[1] + points[i + 2] * top[2]);
  }
  return least;
}

/** The distance of a point from the middle of the sheet: 1 at its edges. */
function placeReach([x, y, z]: Vector, m: ArrayLike<number>): number {
  const depth = m[3] * x + m[7] * y + m[11] * z + m[15];
  if (!(depth > 0)) return Infinity;
  const across = m[0] * x + m[4] * y + m[8] * z + m[12];
  const upwards = m[1] * x + m[5] * y + m[9] * z + m[13];
  return Math.max(Math.abs(across), Math.abs(upwards)) / depth;
}

/** The share of reflected light below which a surface looks less than half as bright as one that faces the light (sRGB). */
const LOOKS_HALF_AS_BRIGHT = 0.214;

/**
 * The share of a seen surface that lies in shade under a distant light: where a white Lambert surface looks less than half as bright as
 * where it faces the light. Baked occlusion counts, cast shadows do not.
 *
 * @param direction unit vector to the light
 * @returns from 0 to 1; 0 if nothing is seen
 */
export function shareOfShade({ normals, openness, pixels }: SeenSurface, [x, y, z]: readonly number[]): number {
  let dark = 0;
  let all = 0;
  for (let part = 0, i = 0; part < pixels.length; part++, i += 3) {
    const facing = normals[i] * x + normals[i + 1] * y + normals[i + 2] * z;
    if (facing * openness[part] < LOOKS_HALF_AS_BRIGHT) dark += pixels[part];
    all += pixels[part];
  }
  return all > 0 ? dark / all : 0;
}

/** The axes of a view, as unit vectors in world space, and the world's up direction. */
interface ViewAxes {
  right: Vector;
  up: Vector;
  toEye: Vector;
  top: Vector;
}

/** The unit vector to a light, and the share of shade under it. */
interface ChosenLight {
  direction: [x: number, y: number, z: number];
  shade: number;
}

/** The wanted share of the visible surface in shade, and the deviation below which directions are equally good. */
const SHADE = { wanted: 0.4, tolerance: 0.03 };
/** The light of a portrait: three-quarter from the front, in degrees from the viewer, and the deviation that is still as good. */
const THREE_QUARTER = { azimuth: 45, elevation: 40, tolerance: 25 };
/** The directions that are tried, in degrees from the viewer: to the left and to the right, all from the front and from above. */
const AZIMUTHS = { least: 15, most: 70, step: 5 };
const ELEVATIONS = { least: 15, most: 65, step: 5 };
/** The penalty of a light from the right, because most people draw with their right hand. */
const LEFT_ADVANTAGE = 0.25;
/** The ratio of reaches below which two shadows are equal. */
const EQUAL_REACH = 1.02;
/** The sine of the least elevation above the horizon: a lower light would cast long shadows. */
const MIN_HEIGHT = Math.sin(Math.PI / 9);

/**
 * Chooses a light that shows a surface well: from the upper left or right in front, so that about two fifths of the visible surface lie
 * in shade. The same surface gets the same light.
 *
 * @param standing what casts a shadow on the ground. The shadow stays on the sheet if there is such a light
 */
export function chooseLight(surface: SeenSurface, axes: ViewAxes, standing?: Standing): ChosenLight {
  const all = [...candidates()].map((candidate) => ({ ...candidate, direction: directionOf(candidate, axes) }));
  const aboveHorizon = all.filter(({ direction }) => dot(direction, axes.top) >= MIN_HEIGHT);
  // In a view from far below, no light in front may be above the horizon.
  const possible = aboveHorizon.length > 0 ? aboveHorizon : all;
  const tried = standing ? withShadowOnSheet(possible, standing) : possible;
  let best: ChosenLight | undefined;
  let least = Infinity;
  for (const { azimuth, direction } of tried) {
    const shade = shareOfShade(surface, direction);
    const ideal = directionOf({ ...THREE_QUARTER, azimuth: Math.sign(azimuth) * THREE_QUARTER.azimuth }, axes);
    const away = degrees(Math.acos(Math.min(1, dot(direction, ideal))));
    const cost =
      ((shade - SHADE.wanted) / SHADE.tolerance) ** 2 +
      (away / THREE_QUARTER.tolerance) ** 2 +
      (azimuth > 0 ? LEFT_ADVANTAGE : 0);
    if (cost >= least) continue;
    least = cost;
    best = { direction, shade };
  }
  return best!;
}

/** The directions under which the shadow stays on the sheet; if there are none, those whose shadow leaves it least. */
function withShadowOnSheet<Lit extends { direction: Vector }>(lights: readonly Lit[], standing: Standing): Lit[] {
  const reaches = lights.map(({ direction }) => shadowReach(standing, direction));
  const most = Math.max(1, EQUAL_REACH * Math.min(...reaches));
  return lights.filter((_, i) => reaches[i] <= most);
}

/** A direction in degrees from the viewer. */
interface Candidate {
  /** Negative to the left. */
  azimuth: number;
  elevation: number;
}

/** Yields all directions that are tried. */
function* candidates(): Generator<Candidate, void, void> {
  for (const side of [-1, 1]) {
    for (let azimuth = AZIMUTHS.least; azimuth <= AZIMUTHS.most; azimuth += AZIMUTHS.step) {
      for (let elevation = ELEVATIONS.least; elevation <= ELEVATIONS.most; elevation += ELEVATIONS.step) {
        yield { azimuth: side * azimuth, elevation };
      }
    }
  }
}

function directionOf({ azimuth, elevation }: Candidate, { right, up, toEye }: ViewAxes): [number, number, number] {
  const level = Math.cos(radians(elevation));
  const sideways = level * Math.sin(radians(azimuth));
  const upwards = Math.sin(radians(elevation));
  const forwards = level * Math.cos(radians(azimuth));
  const along = (axis: 0 | 1 | 2): number => sideways * right[axis] + upwards * up[axis] + forwards * toEye[axis];
  return [along(0), along(1), along(2)];
}

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const radians = (angle: number): number => (angle * Math.PI) / 180;
const degrees = (angle: number): number => (angle * 180) / Math.PI;
