/**
 * The functions of families of lines at a place: cut by a field, as in readCut.glsl, or along the form, level sets of two baked functions,
 * as in readForm.glsl.
 */
import { FIELD_CONSTANTS, FORM_CONSTANTS } from '../../look/constants/lineConstants.js';
import { combined, cross, dot, lengthOf, smoothstep, type Vec3 } from '../../look/vectors.js';
import { across, type Field, fieldAt } from './fieldAxis.js';
import { handPoint, handPressure, slowWaves } from './hand.js';

const { BARE_SLOPE, SIDE_FADE } = FIELD_CONSTANTS;

/** The first family, and two across its axis that the crossing families lean towards. */
export interface CutFamilies {
  field: Field;
  sideB: Vec3;
  sideC: Vec3;
}

export function cutFamilies(field: Field): CutFamilies {
  const sideB = across(field.axis);
  return { field, sideB, sideC: cross(field.axis, sideB) };
}

/** A family: its component along the field, and the side that it leans towards. */
export interface Lean {
  cosine: number;
  sine: number;
  side: 'B' | 'C' | null;
}

/** The values at a place that all families share. */
export interface CutReading {
  /** The position displaced by the hand, tiles. */
  point: Vec3;
  pressure: number;
  value: number;
  /** Unit gradient of the first family's function. */
  gradient: Vec3;
  /** Change of the function along the surface. */
  slope: number;
  /** The share to which the first family has lines here. */
  firstShare: number;
  /** The share of side B in the crossing tone. */
  shareB: number;
}

/** @param place and `normal`, unit, in field space */
export function readCut(
  { field, sideB, sideC }: CutFamilies,
  place: Vec3,
  normal: Vec3,
  irregularity: number,
): CutReading {
  const waves = slowWaves(place);
  const point = handPoint(place, waves, irregularity);
  const { value, gradient } = fieldAt(field, point);
  const slope = Math.max(lengthOf(cross(normal, gradient)), 1e-6);
  const firstShare = smoothstep(BARE_SLOPE[0], BARE_SLOPE[1], slope);
  const between = (dot(normal, sideC) ** 2 - dot(normal, sideB) ** 2) / Math.max(slope * slope, 1e-4);
  const shareB = 1 + firstShare * (smoothstep(-SIDE_FADE, SIDE_FADE, between) - 1);
  return { point, pressure: handPressure(waves, irregularity), value, gradient, slope, firstShare, shareB };
}

const sideOf = ({ sideB, sideC }: CutFamilies, side: 'B' | 'C'): Vec3 => (side === 'B' ? sideB : sideC);

/** The value of a family's function at the displaced position. */
export const familyValue = (
  families: CutFamilies,
  { value, point }: CutReading,
  { cosine, sine, side }: Lean,
): number => (side === null ? value : cosine * value + sine * dot(point, sideOf(families, side)));

/** Its gradient, of any length. */
export const familyGradient = (families: CutFamilies, { gradient }: CutReading, { cosine, sine, side }: Lean): Vec3 =>
  side === null ? gradient : combined(cosine, gradient, sine, sideOf(families, side));

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
  irregularity: number,
  isInk: boolean,
): { value: number; pressure: number } {
  const waves = slowWaves(place);
  const stray = handPoint([0, 0, 0], waves, irregularity);
  return {
    value: rest + dot(gradient, combined(0.5, place, 1, stray)),
    // Strokes and cuts have variations of their own.
    pressure: handPressure(waves, irregularity) + (isInk ? irregularity * WIDTH_WAVE * waves[2] : 0),
  };
}
