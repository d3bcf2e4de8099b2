/** A ground that shows shadows alone, as in tone.glsl, ruledLines.glsl and fieldAxis.glsl. */

import { FIELD_CONSTANTS, GROUND_CONSTANTS } from '../../look/constants/lineConstants.js';
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { combined, cross, lengthOf, type Vec3 } from '../../look/vectors.js';
import { across, type Field } from './fieldAxis.js';
import { hash01 } from './hand.js';
import { type ToneLook, toneFromRadiance } from './tone.js';

const { NO_LIGHT } = TONE_CONSTANTS;
const { ENDING, MOST_ENDING, LEAST_LEFT } = GROUND_CONSTANTS;
const { LEAST_SINE } = FIELD_CONSTANTS;

/** The look of shadows on a ground. */
export interface GroundLook {
  /** A factor on the tone of a full shadow where it touches its occluder, in [0, 1]. */
  tone: number;
  /** The share of the tone that is lost over the width of the shadow map; 0 for none. */
  fade: number;
  /** The width of edges, as a share of the distance from the occluder; 0 for that of the light's shadow. */
  softness: number;
}

/**
 * The tone of shadows on a ground.
 *
 * @param arriving radiance of a white surface there, and `shadowed`, the radiance that shadows take
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
  // Light ink draws the lights: it leaves shadows blank.
  if (toneEnds[1] <= toneEnds[0]) return 0;
  const share = (arriving + NO_LIGHT) / (arriving + shadowed + NO_LIGHT);
  return Math.max(toneFromRadiance(share, look) - share * toneEnds[0], 0) * tone * left;
}

/**
 * A factor on the width of a line where a shadow dissolves: lines end one by one, instead of all thinning out together. The mean over all
 * lines is 1, so the tone stays.
 *
 * @param line its value
 * @param left the share of the shadow there
 */
export function lineLeft(line: number, left: number): number {
  if (left >= 1) return 1;
  const gone = Math.min((ENDING * (1 - left)) / Math.max(left, LEAST_LEFT), MOST_ENDING);
  const kept = gone < 1 ? 1 - 0.5 * gone : 0.5 / gone;
  // Half a turn from the hash of widths, so that the lines that stay are neither the widest nor the thinnest.
  return Math.max(1 - gone * ((hash01(line) + 0.5) % 1), 0) / kept;
}

/**
 * The field across the light and along the ground, whose lines run away from the light.
 *
 * @param light towards it, unit, field space
 * @param normal of the ground, of any length; the coordinate axis nearest to it is used
 */
export function awayField(light: Vec3, normal: Vec3): Field {
  const [x, y, z] = [Math.abs(normal[0]), Math.abs(normal[1]), Math.abs(normal[2])];
  const up: Vec3 = y >= x && y >= z ? [0, 1, 0] : z >= x ? [0, 0, 1] : [1, 0, 0];
  const side = cross(light, up);
  const sine = lengthOf(side);
  return { axis: sine > LEAST_SINE ? combined(1 / sine, side, 0, side) : across(light), bend: 0 };
}
