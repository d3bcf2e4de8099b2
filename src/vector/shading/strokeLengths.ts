/**
 * Strokes that the lines of a family are drawn in, as shaders/techniques/engraved/strokeLengths.glsl has it. They begin and end at places on the
 * object, a power of two apart: as one comes nearer, strokes give way to others half as long.
 */
import { LINE_CONSTANTS, STROKE_LENGTH_CONSTANTS } from '../../look/constants/engravedConstants.js';
import { cross, dot, mix, smoothstep, type Vec3 } from '../../look/vectors.js';
import { octaves, powerOf2 } from './ruledLines.js';
import { type ScreenMap, screenGradient } from './screenGradient.js';

const { PARTS_OF_TILE } = LINE_CONSTANTS;
const { LENGTHS_FADE, AXES_FADE, DIFFERING_OCTAVES, LEAST_DIFFERING } = STROKE_LENGTH_CONSTANTS;

/** Where a place lies along the lines of a family: by two axes of the field, those along which the lines run most. */
export interface Along {
  places: readonly [number, number];
  /** Of the first. */
  share: number;
  /** From the beginning of a stroke to the next, tiles. */
  period: number;
  /** The share of strokes twice as long. */
  longer: number;
}

/** How long strokes are asked to be. */
export interface StrokeLength {
  /** Pixels, or 256ths of a tile. */
  strokeLength: number;
  /** 0: sized on the object, 1: on the screen. */
  sizedOnScreen: number;
}

type Pair = readonly [number, number];

const crossed = (a: Pair, b: Pair): number => Math.abs(a[0] * b[1] - a[1] * b[0]);

/**
 * @param place field space, tiles, where no hand strays
 * @param normal of any length
 * @param gradient of the family's function, of any length
 */
export function alongLines(
  place: Vec3,
  normal: Vec3,
  gradient: Vec3,
  map: ScreenMap,
  { strokeLength, sizedOnScreen }: StrokeLength,
): Along {
  const direction = cross(normal, gradient);
  const size = Math.max(dot(direction, direction), 1e-20);
  const [x, y, z] = direction.map((part) => (part * part) / size);
  // The axis along which the lines run least is left out.
  let [first, second] = [0, 1];
  if (x < Math.min(y, z)) first = 2;
  else if (y < z) second = 2;
  const squares = [x, y, z];
  const share = smoothstep(-AXES_FADE, AXES_FADE, squares[first] - squares[second]);
  const onScreen = screenGradient(gradient, map);
  const length = Math.hypot(...onScreen) || 1;
  const value: Pair = [onScreen[0] / length, onScreen[1] / length];
  const rateOf = (axis: number): number =>
    crossed(screenGradient([Number(axis === 0), Number(axis === 1), Number(axis === 2)], map), value);
  const perPixel = mix(rateOf(second), rateOf(first), share);
  const onObject = octaves(strokeLength / PARTS_OF_TILE);
  const octave = mix(onObject, octaves(strokeLength * Math.max(perPixel, 1e-12)), sizedOnScreen);
  const whole = Math.ceil(octave - 0.5);
  return {
    places: [place[first], place[second]],
    share,
    period: powerOf2(whole),
    longer: smoothstep(1 - LENGTHS_FADE, 1, octave - whole + 0.5),
  };
}

/**
 * How far lines differ, as a share of the most: less where few lie between the repeats of their numbers.
 *
 * @param octave of their distance
 */
export const differing = (octave: number, repeat: number): number =>
  Math.min(Math.max((octaves(repeat) - octave) / DIFFERING_OCTAVES, LEAST_DIFFERING), 1);

/** The number of a line: the same on both sides of a seam but for its sign. repeat: by how much values change there; Infinity without seams. */
export const numberOf = (line: number, repeat: number): number =>
  repeat === Infinity ? line : line - repeat * Math.floor(line / repeat + 0.5);
