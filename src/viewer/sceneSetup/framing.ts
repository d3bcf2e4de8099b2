import { MathUtils, type PerspectiveCamera, Vector3 } from 'three';

/** Default share of the picture's width or height that points fill. */
const POINTS_FILL = 0.94;
/** Default limits of a model and its shadow. */
export const SHADOW_ROOM: ShadowRoom = { model: 0.88, shadow: 0.93, smaller: 1.25 };
/** The model is shrunk before its middle moves aside by more than this share of the way to the edge. */
const CENTRED = 0.09;
/** Once the model is as small as allowed, it moves aside by at most this share. The rest of a long shadow is cut off. */
const MAX_ASIDE = 0.4;
const UP = new Vector3(0, 1, 0);

/** How a model leaves room for its shadow. */
interface ShadowRoom {
  /** The share of the picture that the model may fill while it leaves room. */
  model: number;
  /** The share of the picture that the shadow may fill. */
  shadow: number;
  /** The largest factor by which the model may be shrunk. */
  smaller: number;
}

export interface Framing {
  /** Enlargement of the picture relative to an exact fit; 1 by default. */
  zoom?: number;
  /** The share of the picture's width or height that the points fill; 0.94 by default. */
  fill?: number;
  /** The part of the picture to fit points in, around its middle, in shares of its width and height; all by default. */
  part?: readonly [number, number];
  /** xyz of further points to include, as far as the others stay large enough. */
  shadow?: ArrayLike<number>;
  /** How the points leave room for those; {@link SHADOW_ROOM} by default. */
  room?: ShadowRoom;
}

/**
 * Places a camera so that points just fill its picture from a given direction. The camera's `up` is kept.
 *
 * @param positions xyz of each point
 * @param view direction from the points to the eye, of any length
 * @returns the camera's target: the point on its line of sight nearest to the origin
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

/** Shapes with an aspect between this and its inverse count as square, and suit a sheet in either orientation. */
export const ABOUT_SQUARE = 1.15;

/**
 * The aspect (width / height) of points seen from a given direction.
 *
 * @param upwards the preferred up direction
 */
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
 * How far points reach along one axis of the picture. A point is in the picture if |x − x₀| ≤ slope · (distance − depth), where x₀ is the
 * camera's target. For each side, only the outermost point counts.
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

/** The least distance at which the first span's high side and the second span's low side are in the picture. */
function nearest({ high, slope }: Span, other: Span): number {
  return (high + other.low) / (slope + other.slope);
}

/**
 * The least distances at which each side of a span is in the picture of a camera with the given target.
 *
 * @param aside tolerance of the target per unit of distance
 */
function nearestAround({ low, high, slope }: Span, place: number, aside: number): [number, number] {
  return [(high - place) / (slope + aside), (low + place) / (slope + aside)];
}

/** The target nearest to `place` for which a span is in the picture at a distance; the middle of the span where it does not fit. */
function within({ low, high, slope }: Span, distance: number, place: number): number {
  const least = high - slope * distance;
  const most = slope * distance - low;
  return least > most ? (least + most) / 2 : MathUtils.clamp(place, least, most);
}

/** On a sheet smaller than this, in CSS pixels, strokes become thinner along with the drawing, down to a minimum share. */
export const FULL_SHEET = { width: 640, height: 520 };
export const LEAST_STROKE_SHARE = 0.55;

/** The width of strokes on a sheet of this size, as a share of the settings' width. */
export const strokeShare = (width: number, height: number): number =>
  MathUtils.clamp(Math.min(width / FULL_SHEET.width, height / FULL_SHEET.height), LEAST_STROKE_SHARE, 1);
