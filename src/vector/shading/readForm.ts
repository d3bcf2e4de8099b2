/** Lines that follow the form, at a place, as in readForm.glsl: level sets of two baked functions. */
import { FORM_CONSTANTS } from '../../look/constants/engravedConstants.js';
import { combined, dot, type Vec3 } from '../../look/vectors.js';
import { handPoint, handPressure, slowWaves } from './hand.js';

const { WIDTH_WAVE } = FORM_CONSTANTS;
export const { COARSEST_OCTAVES } = FORM_CONSTANTS;

/** A function at a vertex: its gradient per tile, field space, and its value minus half of the gradient's product with the position. */
export interface FormAt {
  gradient: Vec3;
  rest: number;
}

/** The function as shaders interpolate it. place: field space, tiles. */
export const formVarying = (gradient: Vec3, value: number, place: Vec3): FormAt => ({
  gradient,
  rest: value - 0.5 * dot(gradient, place),
});

/** The value of a function at a position displaced by the hand, and the pressure there. isInk: whether lines are drawn in one go. */
export function readForm(
  { gradient, rest }: FormAt,
  place: Vec3,
  handmade: number,
  isInk: boolean,
): { value: number; pressure: number } {
  const waves = slowWaves(place);
  const stray = handPoint([0, 0, 0], waves, handmade);
  return {
    value: rest + dot(gradient, combined(0.5, place, 1, stray)),
    // Strokes and cuts have variations of their own.
    pressure: handPressure(waves, handmade) + (isInk ? handmade * WIDTH_WAVE * waves[2] : 0),
  };
}
