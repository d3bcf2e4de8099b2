/** Screen-space derivatives of functions on the object, as in shaders/perFragment/screenGradient.glsl. */
import { SCREEN_CONSTANTS } from '../../look/constants/patternConstants.js';
import { cross, dot, lengthOf, type Vec3 } from '../../look/vectors.js';

const { LEAST_FACING } = SCREEN_CONSTANTS;
/** The limit at grazing angles for flat triangles: it only prevents a division by 0. */
const LEAST_FACING_FLAT = 1e-3;

/** The rows of a linear map of vectors. */
export type Mat3 = readonly [Vec3, Vec3, Vec3];

/** A row vector times a matrix, which transforms gradients and normals back. */
const timesMatrix = (v: Vec3, [a, b, c]: Mat3): Vec3 => [
  v[0] * a[0] + v[1] * b[0] + v[2] * c[0],
  v[0] * a[1] + v[1] * b[1] + v[2] * c[1],
  v[0] * a[2] + v[1] * b[2] + v[2] * c[2],
];

/** A tangent plane and its projection to the screen. */
export interface ScreenMap {
  viewToPlace: Mat3;
  /** View space, of any length. */
  normal: Vec3;
  /** The position of the screen's centre relative to the ray of this place, per unit of depth. */
  centre: readonly [number, number];
  /** View units per pixel of the plane, over the length of the normal. */
  scale: number;
}

/** A place as the camera sees it, view space. */
export interface SeenPlace {
  view: Vec3;
  isOrthographic: boolean;
  /** View units per pixel there. */
  unitsPerPixel: number;
}

/**
 * The screen map at a place of a surface.
 *
 * @param normal of any length, in the space of the positions that functions take
 * @param isFlat whether it is the normal of a flat triangle, whose angle is not limited
 */
export function screenMap(normal: Vec3, viewToPlace: Mat3, seen: SeenPlace, isFlat = false): ScreenMap {
  const inView = timesMatrix(normal, viewToPlace);
  const { view, isOrthographic, unitsPerPixel } = seen;
  const centre = isOrthographic ? ([0, 0] as const) : ([view[0] / view[2], view[1] / view[2]] as const);
  const facing = Math.abs(dot(inView, [centre[0], centre[1], 1]));
  const least = (isFlat ? LEAST_FACING_FLAT : LEAST_FACING) * lengthOf(inView);
  return { viewToPlace, normal: inView, centre, scale: unitsPerPixel / Math.max(facing, least, 1e-30) };
}

/** The gradient per pixel of a function, from its gradient in space. It is turned by a right angle, and linear. */
export function screenGradient(
  gradient: Vec3,
  { viewToPlace, normal, centre, scale }: ScreenMap,
): readonly [number, number] {
  const along = cross(normal, timesMatrix(gradient, viewToPlace));
  return [scale * (along[0] - centre[0] * along[2]), scale * (along[1] - centre[1] * along[2])];
}

/** A step on the tangent plane, in view space, from its pixels on the screen, which are turned as those of `screenGradient` are. */
export const stepInView = ([x, y]: readonly [number, number], { normal, centre, scale }: ScreenMap): Vec3 => [
  scale * (x * centre[0] * normal[1] + y * (normal[2] + centre[1] * normal[1])),
  -scale * (x * (normal[2] + centre[0] * normal[0]) + y * centre[1] * normal[0]),
  scale * (x * normal[1] - y * normal[0]),
];

/**
 * The direction on the picture, x to the right and y down, in which a function rises, from its gradient in space. Unit, or the null vector.
 */
export function uphillOnPicture(gradient: Vec3, map: ScreenMap): readonly [number, number] {
  const [x, y] = screenGradient(gradient, map);
  const { normal, centre } = map;
  // Turned back; on front faces the function rises to the right of the turned gradient.
  const length = (Math.sqrt(x * x + y * y) || 1) * Math.sign(dot(normal, [centre[0], centre[1], 1]));
  return length === 0 ? [0, 0] : [y / length, x / length];
}

/** The length of that gradient: units of the function per pixel. */
export function changePerPixel(gradient: Vec3, map: ScreenMap): number {
  const [x, y] = screenGradient(gradient, map);
  return Math.max(Math.sqrt(x * x + y * y), 1e-12);
}
