/** A ground that shows shadows alone, as tone.glsl, ruledLines.glsl and fieldAxis.glsl have it. */

import { FIELD_CONSTANTS, GROUND_CONSTANTS } from '../../look/constants/engravedConstants.js';
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { combined, cross, lengthOf, type Vec3 } from '../../look/vectors.js';
import { across, type Field } from './fieldAxis.js';
import { hash01 } from './hand.js';
import { type ToneLook, toneFromRadiance } from './tone.js';

const { NO_LIGHT } = TONE_CONSTANTS;
const { ENDING, MOST_ENDING, LEAST_LEFT } = GROUND_CONSTANTS;
const { LEAST_SINE } = FIELD_CONSTANTS;

/** How a ground shows shadows. */
export interface GroundLook {
  /** A factor on the tone of a full shadow where it touches what casts it, in [0, 1]. */
  tone: number;
  /** The share of it that is lost at a distance of one width of what the light's shadow covers; 0: none. */
  fade: number;
  /** The width of edges, as a share of the distance from what casts them; 0: as the light's shadow has them. */
  softness: number;
}

/**
 * The tone that shadows print on a ground.
 *
 * @param arriving radiance of a white surface there, and `shadowed`, what shadows have taken of it
 * @param left the share of the tone that has not dissolved
 */
export function groundTone(
  arriving: number,
  shadowed: number,
  left: number,
  look: ToneLook,
  { tone }: GroundLook,
): number {
  const { toneEnds } = look;
  // Light ink draws the lights: its shadows are blank.
  if (toneEnds[1] <= toneEnds[0]) return 0;
  const share = (arriving + NO_LIGHT) / (arriving + shadowed + NO_LIGHT);
  return Math.max(toneFromRadiance(share, look) - share * toneEnds[0], 0) * tone * left;
}

/**
 * Where a shadow dissolves its lines end one by one: the width of a line as a factor on what it would be if all thinned out together. The mean
 * over all lines is 1, so that the tone is the same.
 *
 * @param line its value
 * @param left the share of the shadow there
 */
export function lineLeft(line: number, left: number): number {
  if (left >= 1) return 1;
  const gone = Math.min((ENDING * (1 - left)) / Math.max(left, LEAST_LEFT), MOST_ENDING);
  const kept = gone < 1 ? 1 - 0.5 * gone : 0.5 / gone;
  // Half a turn from the hash by which widths differ: those that stay are neither the wide ones nor the thin ones.
  return Math.max(1 - gone * ((hash01(line) + 0.5) % 1), 0) / kept;
}

/**
 * The field across the light and across the ground, whose lines run away from the light.
 *
 * @param light towards it, unit, field space
 * @param normal of the ground, of any length: the axis that leans least from it stands for it
 */
export function awayField(light: Vec3, normal: Vec3): Field {
  const [x, y, z] = [Math.abs(normal[0]), Math.abs(normal[1]), Math.abs(normal[2])];
  const up: Vec3 = y >= x && y >= z ? [0, 1, 0] : z >= x ? [0, 0, 1] : [1, 0, 0];
  const side = cross(light, up);
  const sine = lengthOf(side);
  return { axis: sine > LEAST_SINE ? combined(1 / sine, side, 0, side) : across(light), bend: 0 };
}
