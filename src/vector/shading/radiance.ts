/** What arrives of lamps at a surface, as radiance.glsl and three's own chunks have it. All in world space. */
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { cross, dot, lengthOf, type Vec3 } from '../../look/vectors.js';

/** A light with a direction. */
export interface Lamp {
  luminance: number;
  /** The unit vector to one that is far away, or where one at a place is. */
  at: Vec3;
  isFar: boolean;
  /** Where its light ends, world units, 0 without an end; and how it falls off. */
  distance: number;
  decay: number;
  /** Of a spot: from its target to it, unit, and the cosines where its cone ends and where it is whole. */
  cone: { axis: Vec3; outer: number; inner: number } | null;
  castsShadow: boolean;
}

/** How a surface answers to light from a direction. */
export type ToneModel = 'lambert' | 'halfLambert' | 'phong' | 'toon';

/** The share of a light that is left at a distance, as three.js has it. */
export function attenuation(length: number, { distance, decay }: Pick<Lamp, 'distance' | 'decay'>): number {
  const left = 1 / Math.max(length ** decay, 0.01);
  return distance > 0 ? left * Math.max(0, Math.min(1, 1 - (length / distance) ** 4)) ** 2 : left;
}

/** What arrives of a lamp at a point. */
export interface Arriving {
  /** Towards the lamp, unit. */
  direction: Vec3;
  /** How far away it is, world units; endless for one that is far away. */
  length: number;
  /** The luminance that arrives, and that would without a cone. */
  luminance: number;
  coneless: number;
}

/** What arrives of a lamp at a point, but for shadows. */
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
  if (inner <= outer) return cosine >= outer ? 1 : 0;
  const t = Math.min(1, Math.max(0, (cosine - outer) / (inner - outer)));
  return t * t * (3 - 2 * t);
}

/**
 * The response of a surface to light from a direction.
 *
 * @param toViewer unit, which a highlight depends on
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

/** What the surroundings reflect of a light: most to the side that is turned away, and to planes that face one side of it more. */
export function reflectedTo(normal: Vec3, direction: Vec3, isPlane: boolean): number {
  const behind = 0.5 - 0.5 * dot(normal, direction);
  if (!isPlane) return behind;
  const side = cross(direction, SIDE_AXIS);
  const facing = Math.max(dot(normal, side), 0) / Math.max(lengthOf(side), 1e-20);
  return behind + BESIDE_LIGHT * Math.max(behind - BESIDE_FROM, 0) * facing;
}
