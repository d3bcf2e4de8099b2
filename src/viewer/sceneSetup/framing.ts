import { MathUtils, type PerspectiveCamera, Vector3 } from 'three';

/** The share of the picture that points fill unless asked otherwise, of its width or its height. */
const POINTS_FILL = 0.94;
/** How far a model and its shadow may go towards the edges, unless asked otherwise. */
export const SHADOW_ROOM: ShadowRoom = { model: 0.88, shadow: 0.93, smaller: 1.25 };
/** A model is drawn smaller before its middle moves aside by more than this share of the way to the edge. */
const CENTRED = 0.09;
/** If it is as small as it may be, it moves aside by at most this share. What is left of a long shadow is cut. */
const MAX_ASIDE = 0.4;
const UP = new Vector3(0, 1, 0);

/** How a model leaves room for its shadow. */
export interface ShadowRoom {
  /** The share of the picture that the model may fill to leave room for its shadow. */
  model: number;
  /** The share of the picture that the shadow may fill. */
  shadow: number;
  /** How many times smaller the model may be drawn. */
  smaller: number;
}

export interface Framing {
  /** How many times larger the picture is than one that the points just fill; 1 by default. */
  zoom?: number;
  /** The share of the picture that the points fill, of its width or its height; 0.94 by default. */
  fill?: number;
  /** The part of the picture that counts as the picture, around its middle, in shares of its width and height; all of it by default. */
  part?: readonly [number, number];
  /** xyz of points that are in the picture as well, as far as that leaves the others large enough. */
  shadow?: ArrayLike<number>;
  /** How the points leave room for those; as {@link SHADOW_ROOM} by default. */
  room?: ShadowRoom;
}

/**
 * Places a camera so that points just fill its picture, seen from a given direction. What its `up` says points up in the picture.
 *
 * @param positions xyz of each point
 * @param view direction from the points to the eye, of any length
 * @returns what the camera looks at: of its line of sight, the point nearest to the origin
 */
export function fitCamera(
  camera: PerspectiveCamera,
  positions: ArrayLike<number>,
  view: Vector3,
  { zoom = 1, fill = POINTS_FILL, part = [1, 1], shadow, room = SHADOW_ROOM }: Framing = {},
): Vector3 {
  const axes = frustumAxes(camera, view, part);
  const model = spansOf(positions, axes, fill);
  let distance = Math.max(...model.map((span) => nearest(span, span)));
  let middle = model.map(({ low, high }) => (high - low) / 2);
  if (shadow && shadow.length > 0) {
    const aside = spansOf(positions, axes, room.model);
    const cast = spansOf(shadow, axes, room.shadow);
    const forBoth = [0, 1].flatMap((axis) => [
      nearest(cast[axis], cast[axis]),
      nearest(cast[axis], aside[axis]),
      nearest(aside[axis], cast[axis]),
      ...nearestAround(cast[axis], middle[axis], CENTRED * axes.slopes[axis]),
    ]);
    distance = Math.min(Math.max(distance, ...forBoth), room.smaller * distance);
    middle = middle.map((place, axis) => {
      const most = MAX_ASIDE * axes.slopes[axis] * distance;
      const balanced = MathUtils.clamp(within(cast[axis], distance, place), place - most, place + most);
      return within(aside[axis], distance, balanced);
    });
  }
  const target = axes.right.clone().multiplyScalar(middle[0]).addScaledVector(axes.up, middle[1]);
  camera.position.copy(target).addScaledVector(axes.toEye, distance / zoom);
  camera.lookAt(target);
  return target;
}

/** Points whose proportion lies between this and its inverse are about as wide as high, and suit a sheet in either orientation. */
export const ABOUT_SQUARE = 1.15;

/** How many times wider than high points are, seen from a given direction. @param upwards what points up on the sheet, as near as can be */
export function proportionOf(positions: ArrayLike<number>, view: Vector3, upwards: Vector3 = UP): number {
  const { right, up } = viewAxes(view, upwards);
  const [wide, high] = [right, up].map((axis) => {
    let [low, most] = [Infinity, -Infinity];
    for (let i = 0; i < positions.length; i += 3) {
      const x = axis.x * positions[i] + axis.y * positions[i + 1] + axis.z * positions[i + 2];
      low = Math.min(low, x);
      most = Math.max(most, x);
    }
    return most - low;
  });
  return wide / high;
}

/** The axes of a camera that looks against `view`, and how fast its frustum widens along two of them. */
interface FrustumAxes {
  toEye: Vector3;
  right: Vector3;
  up: Vector3;
  slopes: readonly [number, number];
}

function frustumAxes(camera: PerspectiveCamera, view: Vector3, part: readonly [number, number]): FrustumAxes {
  const slope = Math.tan(MathUtils.degToRad(camera.fov) / 2);
  return { ...viewAxes(view, camera.up), slopes: [part[0] * slope * camera.aspect, part[1] * slope] };
}

function viewAxes(view: Vector3, upwards: Vector3): Omit<FrustumAxes, 'slopes'> {
  const toEye = view.clone().normalize();
  const right = upwards.clone().cross(toEye).normalize();
  return { toEye, right, up: toEye.clone().cross(right) };
}

/**
 * How far points reach along one axis of the picture. A point is in the picture if |x − x₀| ≤ slope · (distance − depth), where
 * x₀ is what the camera looks at. For each side, only the point that is farthest out counts.
 */
interface Span {
  /** The largest of −x + slope · depth. */
  low: number;
  /** The largest of x + slope · depth. */
  high: number;
  slope: number;
}

/** The spans of points along the axes to the right and up. @param fill share of the picture that they may fill */
function spansOf(positions: ArrayLike<number>, { toEye, right, up, slopes }: FrustumAxes, fill: number): Span[] {
  const point = new Vector3();
  const axes = [right, up];
  const spans = slopes.map((slope) => ({ low: -Infinity, high: -Infinity, slope: slope * fill }));
  for (let i = 0; i < positions.length; i += 3) {
    point.fromArray(positions, i);
    const depth = point.dot(toEye);
    for (const [axis, span] of spans.entries()) {
      const x = point.dot(axes[axis]);
      span.low = Math.max(span.low, -x + span.slope * depth);
      span.high = Math.max(span.high, x + span.slope * depth);
    }
  }
  return spans;
}

/** The smallest distance at which the first span is in the picture at its high side and the second at its low side. */
function nearest({ high, slope }: Span, other: Span): number {
  return (high + other.low) / (slope + other.slope);
}

/**
 * The smallest distances at which each side of a span is in the picture of a camera that looks at a place, or next to it.
 *
 * @param aside how far next to it, by distance
 */
function nearestAround({ low, high, slope }: Span, place: number, aside: number): [number, number] {
  return [(high - place) / (slope + aside), (low + place) / (slope + aside)];
}

/** What the camera may look at from a distance so that a span is in the picture, next to `place`; its middle where it has no room. */
function within({ low, high, slope }: Span, distance: number, place: number): number {
  const least = high - slope * distance;
  const most = slope * distance - low;
  return least > most ? (least + most) / 2 : MathUtils.clamp(place, least, most);
}
