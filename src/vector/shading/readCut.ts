/** The families of lines that a field cuts out of an object, at a place, as readCut.glsl has them. */

import { FIELD_CONSTANTS } from '../../look/constants/engravedConstants.js';
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

/** A family: how much of the first field it has, and of which side. */
export interface Lean {
  cosine: number;
  sine: number;
  side: 'B' | 'C' | null;
}

/** What is known at a place. */
export interface CutReading {
  /** As the hand strays, tiles. */
  point: Vec3;
  pressure: number;
  value: number;
  /** Of the first family's function, unit. */
  gradient: Vec3;
  /** Its change along the surface. */
  slope: number;
  /** How far the first family has lines. */
  has: number;
  /** What the family towards side B takes of what crosses. */
  shareB: number;
}

/** @param place and `normal`, unit, in field space */
export function readCut({ field, sideB, sideC }: CutFamilies, place: Vec3, normal: Vec3, handmade: number): CutReading {
  const waves = slowWaves(place);
  const point = handPoint(place, waves, handmade);
  const { value, gradient } = fieldAt(field, point);
  const slope = Math.max(lengthOf(cross(normal, gradient)), 1e-6);
  const has = smoothstep(BARE_SLOPE[0], BARE_SLOPE[1], slope);
  const between = (dot(normal, sideC) ** 2 - dot(normal, sideB) ** 2) / Math.max(slope * slope, 1e-4);
  const shareB = 1 + has * (smoothstep(-SIDE_FADE, SIDE_FADE, between) - 1);
  return { point, pressure: handPressure(waves, handmade), value, gradient, slope, has, shareB };
}

const sideOf = ({ sideB, sideC }: CutFamilies, side: 'B' | 'C'): Vec3 => (side === 'B' ? sideB : sideC);

/** The value of a family's function where the hand puts a place. */
export const familyValue = (
  families: CutFamilies,
  { value, point }: CutReading,
  { cosine, sine, side }: Lean,
): number => (side === null ? value : cosine * value + sine * dot(point, sideOf(families, side)));

/** Its gradient, of any length. */
export const familyGradient = (families: CutFamilies, { gradient }: CutReading, { cosine, sine, side }: Lean): Vec3 =>
  side === null ? gradient : combined(cosine, gradient, sine, sideOf(families, side));
