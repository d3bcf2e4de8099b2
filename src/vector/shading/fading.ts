/** The share of ink that fading leaves at a place, as in fading.glsl: 1 where nothing fades. */
import { FADING_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { clamp01, combined, dot, lengthOf, smoothstep, type Vec3 } from '../../look/vectors.js';

const { AIR, FRONT_GAIN, FOCUS_END, VIGNETTE_START, UNEVEN } = FADING_CONSTANTS;

/** The fading of an object. */
export interface ObjectFading {
  /** Depths at which fading begins and ends, world units, and its strength. */
  depthFading: readonly [from: number, to: number, strength: number];
  /** The point in focus, world space, and its radius; null for none. */
  focus: { at: Vec3; radius: number } | null;
  /** Strength of the falloff towards the rim of the sheet, from 0 to 1. */
  vignette: number;
  /** Lower left corner and size of the sheet, in widths and heights of the picture, which may be a part of a larger one. */
  sheet: readonly [x: number, y: number, width: number, height: number];
  /** Importance of the object, from 0 to 1. */
  importance: number;
}

/** A place that is drawn. */
export interface FadedPlace {
  world: Vec3;
  /** Distance before the camera, along its axis. */
  depth: number;
  /** Position on the picture, from its lower left corner, in its widths and heights. */
  onPicture: readonly [number, number];
}

function airBefore(depth: number, [from, to, strength]: ObjectFading['depthFading']): number {
  if (strength === 0) return 0;
  return (1 - Math.exp(-AIR * clamp01((depth - from) / (to - from)))) / (1 - Math.exp(-AIR));
}

/** The irregularity of a hand-drawn edge, within ±UNEVEN. The numbers are arbitrary. */
function uneven(p: Vec3): number {
  const a = Math.sin(dot(p, [4.3, 3.1, -3.7]) + 1.6 * Math.sin(dot(p, [-2.9, 5.3, 4.1])));
  const b = Math.sin(dot(p, [-11, 13, 9]) + 1.3 * Math.sin(dot(p, [7, -5, 6])) + 2);
  return UNEVEN * (0.65 * a + 0.35 * b);
}

function inFocus(world: Vec3, focus: ObjectFading['focus']): number {
  if (focus === null) return 1;
  const away = combined(1 / focus.radius, world, -1 / focus.radius, focus.at);
  return 1 - smoothstep(1, FOCUS_END, lengthOf(away) * (1 + uneven(away)));
}

function onSheet([x, y]: readonly [number, number], { vignette, sheet }: ObjectFading): number {
  if (vignette === 0) return 1;
  const away: Vec3 = [(2 * (x - sheet[0])) / sheet[2] - 1, (2 * (y - sheet[1])) / sheet[3] - 1, 0];
  const wavering = 1 + uneven(combined(2, away, 0, away));
  return 1 - vignette * smoothstep(VIGNETTE_START, 1, lengthOf(away) * wavering);
}

/** A factor on the tone. */
export function fadingAt(fading: ObjectFading, { world, depth, onPicture }: FadedPlace): number {
  const { importance, focus, depthFading } = fading;
  const inAir = 1 - depthFading[2] * airBefore(depth, depthFading);
  return importance * inFocus(world, focus) * onSheet(onPicture, fading) * inAir;
}

/** A factor on the width of outlines, up to 1.4. */
export function outlineFadingAt(fading: ObjectFading, place: FadedPlace): number {
  const { depthFading } = fading;
  return fadingAt(fading, place) * (1 + FRONT_GAIN * depthFading[2] * (1 - airBefore(place.depth, depthFading)));
}
