/** The light of lamps that arrives at a surface, as in radiance.glsl and three.js' chunks. World space. */
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import type { Sky } from '../../look/surroundings.js';
import { clamp01, combined, cross, dot, lengthOf, smoothstep, type Vec3 } from '../../look/vectors.js';

/** A light with a direction. */
export interface Lamp {
  luminance: number;
  /** Unit vector towards a directional light, or position of another. */
  at: Vec3;
  isFar: boolean;
  /** Reach of the light, world units, 0 for no limit; and its decay. */
  distance: number;
  decay: number;
  /** Of a spot light: unit vector from its target to it, and cosines of the outer and the inner angle of its cone. */
  cone: { axis: Vec3; outer: number; inner: number } | null;
  castsShadow: boolean;
}

/** The response of a surface to light from a direction. */
export type ToneModel = 'lambert' | 'halfLambert' | 'phong' | 'toon';

/** Attenuation of a light over a distance, as in three.js. */
export function attenuation(length: number, { distance, decay }: Pick<Lamp, 'distance' | 'decay'>): number {
  const left = 1 / Math.max(length ** decay, 0.01);
  return distance > 0 ? left * clamp01(1 - (length / distance) ** 4) ** 2 : left;
}

/** The light of a lamp at a point. */
export interface Arriving {
  /** Unit vector towards the lamp. */
  direction: Vec3;
  /** Distance, world units; Infinity for directional lights. */
  length: number;
  /** The luminance that arrives, and that would without a cone. */
  luminance: number;
  coneless: number;
}

/** The light of a lamp at a point, without shadows. */
export function arriving(lamp: Lamp, point: Vec3): Arriving {
  const { at, isFar, luminance, cone } = lamp;
  if (isFar) return { direction: at, length: Infinity, luminance, coneless: luminance };
  const way: Vec3 = [at[0] - point[0], at[1] - point[1], at[2] - point[2]];
  const length = Math.max(lengthOf(way), 1e-20);
  const direction: Vec3 = [way[0] / length, way[1] / length, way[2] / length];
  const coneless = luminance * attenuation(length, lamp);
  return { direction, length, luminance: cone ? coneless * inCone(cone, direction) : coneless, coneless };
}

function inCone({ axis, outer, inner }: NonNullable<Lamp['cone']>, direction: Vec3): number {
  const cosine = dot(axis, direction);
  return inner <= outer ? Number(cosine >= outer) : smoothstep(outer, inner, cosine);
}

/**
 * The response of a surface to light from a direction.
 *
 * @param toViewer unit, for highlights
 */
export function responseTo(model: ToneModel, normal: Vec3, direction: Vec3, toViewer: Vec3, shininess: number): number {
  const cosine = dot(normal, direction);
  if (model === 'halfLambert') return (0.5 * cosine + 0.5) ** 2;
  const plain = Math.max(cosine, 0);
  if (model !== 'phong' || cosine < 0) return plain;
  const mirrored = 2 * cosine * dot(normal, toViewer) - dot(direction, toViewer);
  return plain + Math.max(mirrored, 1e-6) ** shininess;
}

const { BESIDE_FROM, BESIDE_LIGHT, SIDE_AXIS } = TONE_CONSTANTS;

/**
 * The share of a light that the surroundings reflect: greatest on the side that faces away, and greater on the planes that face one side of
 * it.
 */
export function reflectedTo(normal: Vec3, direction: Vec3, isPlane: boolean): number {
  const behind = 0.5 - 0.5 * dot(normal, direction);
  if (!isPlane) return behind;
  const side = cross(direction, SIDE_AXIS);
  const facing = Math.max(dot(normal, side), 0) / Math.max(lengthOf(side), 1e-20);
  return behind + BESIDE_LIGHT * Math.max(behind - BESIDE_FROM, 0) * facing;
}

/** The direction from which light comes at a place in the world, for the shading of outlines: the mean of all lights, of any length. */
export function meanLightAt(place: Vec3, lamps: readonly Lamp[], skies: readonly Sky[]): Vec3 {
  let sum: Vec3 = [0, 0, 0];
  for (const lamp of lamps) {
    const { direction, luminance } = arriving(lamp, place);
    sum = combined(1, sum, luminance, direction);
  }
  for (const { up, difference } of skies) sum = combined(1, sum, difference, up);
  return sum;
}
