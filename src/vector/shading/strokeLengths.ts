/**
 * The strokes that the lines of a family are drawn in, as in shaders/techniques/lines/strokeLengths.glsl. They begin and end at fixed
 * places on the object, a power of two apart: as the camera comes nearer, strokes split into halves.
 */
import { LINE_CONSTANTS, STROKE_LENGTH_CONSTANTS } from '../../look/constants/lineConstants.js';
import { cross, dot, mix, smoothstep, type Vec3 } from '../../look/vectors.js';
import { octaves, powerOf2 } from './ruledLines.js';
import { type ScreenMap, screenGradient } from './screenGradient.js';

const { PARTS_OF_TILE } = LINE_CONSTANTS;
const { LENGTHS_FADE, AXES_FADE, DIFFERING_OCTAVES, LEAST_DIFFERING } = STROKE_LENGTH_CONSTANTS;

/** The coordinates of a place along the lines of a family: on the two axes of the field along which the lines run most. */
export interface Along {
  places: readonly [number, number];
  /** Share of the first axis. */
  share: number;
  /** Length of a stroke with its gap, tiles. */
  period: number;
  /** Share of strokes twice as long. */
  longer: number;
}

/** The length of strokes. */
export interface StrokeLength {
  /** Pixels, or 256ths of a tile. */
  strokeLength: number;
  /** 0: sized on the object, 1: on the screen. */
  screenSpaceShare: number;
}

type Pair = readonly [number, number];

export const crossed = (a: Pair, b: Pair): number => Math.abs(a[0] * b[1] - a[1] * b[0]);

/**
 * The two axes of the field along which lines run most, and the share of the first.
 *
 * @param normal of any length
 * @param gradient of the function whose level sets are lines, of any length
 */
export function axesAlong(normal: Vec3, gradient: Vec3): { first: number; second: number; share: number } {
  const direction = cross(normal, gradient);
  const size = Math.max(dot(direction, direction), 1e-20);
  const squares = direction.map((part) => (part * part) / size);
  const [x, y, z] = squares;
  // The axis along which the lines run least is left out.
  let [first, second] = [0, 1];
  if (x < Math.min(y, z)) first = 2;
  else if (y < z) second = 2;
  return { first, second, share: smoothstep(-AXES_FADE, AXES_FADE, squares[first] - squares[second]) };
}

/** The unit vector along an axis of the field. */
export const axisOf = (axis: number): Vec3 => [Number(axis === 0), Number(axis === 1), Number(axis === 2)];

/**
 * @param place field space, tiles, before the hand displaces it
 * @param normal of any length
 * @param gradient of the family's function, of any length
 */
export function alongLines(
  place: Vec3,
  normal: Vec3,
  gradient: Vec3,
  map: ScreenMap,
  { strokeLength, screenSpaceShare }: StrokeLength,
): Along {
  const { first, second, share } = axesAlong(normal, gradient);
  const onScreen = screenGradient(gradient, map);
  const length = Math.hypot(...onScreen) || 1;
  const value: Pair = [onScreen[0] / length, onScreen[1] / length];
  const rateOf = (axis: number): number => crossed(screenGradient(axisOf(axis), map), value);
  const perPixel = mix(rateOf(second), rateOf(first), share);
  const onObject = octaves(strokeLength / PARTS_OF_TILE);
  const octave = mix(onObject, octaves(strokeLength * Math.max(perPixel, 1e-12)), screenSpaceShare);
  const whole = Math.ceil(octave - 0.5);
  return {
    places: [place[first], place[second]],
    share,
    period: powerOf2(whole),
    longer: smoothstep(1 - LENGTHS_FADE, 1, octave - whole + 0.5),
  };
}

/**
 * The amplitude of variation from line to line, as a share of the greatest: less if few lines lie between repeats of their numbers.
 *
 * @param octave of their spacing
 */
export const differing = (octave: number, repeat: number): number =>
  Math.min(Math.max((octaves(repeat) - octave) / DIFFERING_OCTAVES, LEAST_DIFFERING), 1);

/**
 * The number of a line: the same on both sides of a seam, except for its sign. repeat: the step of values across seams; Infinity without
 * seams.
 */
export const numberOf = (line: number, repeat: number): number =>
  repeat === Infinity ? line : line - repeat * Math.floor(line / repeat + 0.5);
