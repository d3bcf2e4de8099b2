import { MathUtils, type PerspectiveCamera, Vector3 } from 'three';
import { LensCamera } from './LensCamera.js';

/** What is looked at of a shadow that nears the edges of the sheet: from the first share of the way there on, and wholly at the second. */
const NEARS_EDGE = { from: 0.86, to: 0.97 } as const;
/** A shadow dissolves no faster, so that something of it is left where a body touches the ground. */
const MOST_FADE = 6;
/** So many points tell how far a shadow reaches. */
const ENOUGH_POINTS = 1500;

/** A light that casts a shadow on the ground. */
export interface GroundLight {
  /** The position of a lamp, or the direction to a sun. */
  position: Vector3;
  isSun: boolean;
  /** The width that its shadow's camera sees at a place, by which a shadow fades. */
  widthAt(place: Vector3): number;
}

/** The part of the picture that counts as the sheet, around its middle, in shares of its width and height. */
export type SheetPart = readonly [number, number];

/** A picture that is all sheet. */
export const WHOLE_SHEET: SheetPart = [1, 1];

const point = new Vector3();
const cast = new Vector3();
const seen = new Vector3();

/**
 * How fast a shadow on level ground must dissolve to end before the edges of the sheet, as `shadowFade` has it; 0 where it lies on the sheet.
 * What is off the sheet itself casts its shadow as it likes. Allocates nothing.
 *
 * @param points xyz of points of the model
 * @param ground its height
 */
export function fadeOnSheet(
  points: ArrayLike<number>,
  ground: number,
  light: GroundLight,
  camera: PerspectiveCamera,
  part: SheetPart,
): number {
  camera.updateMatrixWorld();
  const step = 3 * Math.ceil(points.length / 3 / ENOUGH_POINTS);
  let fade = 0;
  for (let i = 0; i + 2 < points.length; i += step) {
    point.set(points[i], points[i + 1], points[i + 2]);
    if (!castPoint(light, ground) || reachOf(point, camera, part) > 1) continue;
    const share = MathUtils.smoothstep(reachOf(cast, camera, part), NEARS_EDGE.from, NEARS_EDGE.to);
    if (share > 0) fade = Math.max(fade, (share * light.widthAt(cast)) / cast.distanceTo(point));
  }
  return Math.min(fade, MOST_FADE);
}

/** Where the point casts its shadow. @returns whether it casts one */
function castPoint({ position, isSun }: GroundLight, ground: number): boolean {
  if (isSun) cast.copy(position).negate();
  else cast.subVectors(point, position);
  if (cast.y >= 0 || point.y <= ground) return false;
  cast.multiplyScalar((ground - point.y) / cast.y).add(point);
  return true;
}

/** How far a place is from the middle of the sheet: 1 at its edges. */
function reachOf(place: Vector3, camera: PerspectiveCamera | LensCamera, [wide, high]: SheetPart): number {
  const { x, y, z } = seen.copy(place).applyMatrix4(camera.matrixWorldInverse);
  if (z >= 0) return Infinity;
  const isFlat = camera instanceof LensCamera && camera.lens?.isOrthographic;
  const half = isFlat ? camera.top : -z * Math.tan(MathUtils.degToRad(camera.fov) / 2);
  return Math.max(Math.abs(x) / (half * camera.aspect * wide), Math.abs(y) / (half * high));
}
