import { SHADOW_CONSTANTS, SHADOW_SAMPLES } from '../look/constants/shadingConstants.js';
import { combined, cross, dot, normalize, type Vec3 } from '../look/vectors.js';
import type { Bvh } from './Bvh.js';
import type { GroundLook } from './shading/groundShadow.js';
import type { Lamp } from './shading/radiance.js';

/** The shadow map of a light on the canvas. */
export interface LampShadow {
  /** Texels along a side of the map, and the radius of its filter, texels. */
  texels: number;
  radius: number;
  /** Darkness of the shadow, from 0 to 1. */
  intensity: number;
  /** Whether it is a cube map. */
  isCube: boolean;
  /** Width of the map across the light, world units; for a positional light that at distance 1. */
  width: number;
}

/** The shadow of a lamp at a place, found by rays. */
export interface ReceivedShadow {
  /** The share of the light that arrives. */
  passing: number;
  /** The share of the shadow's tone that has not dissolved; less than 1 only on a ground. */
  left: number;
  /** Whether the place lies within a soft edge. */
  isEdge: boolean;
}

/** Farther than any light. */
const FAR = 1e9;
const { MOST_SAMPLES, FARTHEST_CASTER, TOWARDS_LAMP, LIFT, THINNEST, OVERHEAD } = SHADOW_CONSTANTS;
/** Rays to points on a lamp; after those to its rim it is known whether there is an edge. */
const { EDGE_SAMPLES: RAYS, RIM_SAMPLES: RIM } = SHADOW_SAMPLES;
/** Rays that start beside a place start in its tangent plane, and hard ones straight towards the light, unless its cosine to the light is less than this. */
const LEAST_LEAN = 0.25;

export const LIT: ReceivedShadow = { passing: 1, left: 1, isEdge: false };
/** Where no light arrives. */
export const SHADED: ReceivedShadow = { passing: 0, left: 1, isEdge: false };
const MIDDLE: readonly [number, number] = [0, 0];

const shadowWith = (passing: number, left: number): ReceivedShadow => ({
  ...{ passing, left },
  isEdge: passing > 0 && passing < 1,
});

/** Points on the unit disc in a sunflower pattern, outermost first, so that those of the rim lie evenly around it. */
const DISC = Array.from({ length: RAYS }, (_, i): readonly [number, number] => {
  const outward = Math.sqrt((RAYS - i - 0.5) / RAYS);
  const angle = i < RIM ? (2 * Math.PI * i) / RIM : i * Math.PI * (3 - Math.sqrt(5));
  return [outward * Math.cos(angle), outward * Math.sin(angle)];
});

/**
 * The radius of a disc that softens an edge as much as the filter of a map.
 *
 * @param radius of the light's shadow, and `blend`, the width of the bilinear filter, in the same unit
 */
function kernelRadius(radius: number, blend: number): number {
  const samples = Math.min(Math.ceil(radius), MOST_SAMPLES);
  const step = samples > 0 ? radius / samples : 0;
  // A tent of half-width a has variance a²/6, and a disc of radius r has r²/4.
  return Math.sqrt((2 / 3) * (step * step * ((samples + 1) ** 2 - 1) + blend * blend));
}

/** Rays from around a place to around a lamp. */
interface Bundle {
  from: Vec3;
  /** Unit vector to the lamp. */
  towards: Vec3;
  /** Distance of the lamp, world units. */
  end: number;
  /** Unit vectors across the ray, and the offsets along the ray at which their ends meet the tangent plane. */
  side: Vec3;
  up: Vec3;
  besides: Vec3;
  above: Vec3;
}

function bundleOf(from: Vec3, normal: Vec3, towards: Vec3, length: number): Bundle {
  const side = normalize(cross(towards, Math.abs(towards[1]) < OVERHEAD ? [0, 1, 0] : [1, 0, 0]));
  const up = cross(towards, side);
  // Rays that start in the tangent plane do not hit the surface's own neighbourhood.
  const lean = 1 / Math.max(dot(normal, towards), LEAST_LEAN);
  const onSurface = (way: Vec3): Vec3 => combined(1, way, -lean * dot(way, normal), towards);
  return { from, towards, end: Math.min(length, FAR), side, up, besides: onSurface(side), above: onSurface(up) };
}

/** Computes the shadows of lamps by rays: hard, or as soft as those of the canvas' shadow maps. */
export class ShadowRays {
  /** The ray that is cast: where it starts, and its way. */
  private readonly from: [number, number, number] = [0, 0, 0];
  private readonly way: [number, number, number] = [0, 0, 0];

  /**
   * @param bias height above bodies at which rays start, world units
   * @param isSoft whether edges are soft; otherwise there is one ray per shadow
   */
  constructor(
    private readonly bvh: Bvh,
    private readonly bias: number,
    private readonly isSoft: boolean,
  ) {}

  /**
   * The shadow of a lamp at a place with a normal.
   *
   * @param direction towards the lamp, unit, and `length`, its distance; Infinity for directional lights
   * @param ground look of a ground that shows shadows alone; null for a body
   * @param isSoft false for one ray, which tells the same outside of soft edges
   */
  shadowOf(
    lamp: Lamp,
    shadow: LampShadow,
    place: { world: Vec3; normal: Vec3; direction: Vec3; length: number },
    ground: GroundLook | null,
    isSoft = this.isSoft,
  ): ReceivedShadow {
    const { world, normal, direction, length } = place;
    const width = widthAt(lamp, shadow, direction, length);
    const from = ground ? world : combined(1, world, this.bias, normal);
    const bundle = bundleOf(from, normal, direction, length);
    const found = ground
      ? this.onGround(bundle, shadow, ground, width, isSoft)
      : this.onBody(bundle, shadow, width, isSoft);
    return { ...found, passing: 1 - shadow.intensity * (1 - found.passing) };
  }

  /** The share of the light of a lamp that passes to a place of a body, with a hard edge. Its place is that of `shadowOf`. */
  hardPassing(
    { intensity }: LampShadow,
    { world, normal, direction, length }: { world: Vec3; normal: Vec3; direction: Vec3; length: number },
  ): number {
    // Raised along the ray the place casts the same shadow, but at grazing angles that would lead far away.
    const facing = dot(normal, direction);
    const along = this.bias / Math.max(facing, LEAST_LEAN);
    const raised = combined(1, world, along, direction);
    const bundle = bundleOf(combined(1, raised, this.bias - along * facing, normal), normal, direction, length);
    return this.isMet(bundle, MIDDLE, 0, 0, 0) ? 1 - intensity : 1;
  }

  private onBody(bundle: Bundle, shadow: LampShadow, width: number, isSoft: boolean): ReceivedShadow {
    if (!isSoft) return this.isMet(bundle, MIDDLE, 0, 0, 0) ? SHADED : LIT;
    return shadowWith(this.passing(bundle, mapSoftness(shadow, bundle.end, width), 0, 0), 1);
  }

  private onGround(
    bundle: Bundle,
    shadow: LampShadow,
    { fade, softness }: GroundLook,
    width: number,
    isSoft: boolean,
  ): ReceivedShadow {
    const texel = width / shadow.texels;
    const lift = LIFT * texel;
    const opening = isSoft ? 0.5 * softness : 0;
    const edge = softness > 0 ? Math.max(shadow.radius, THINNEST) * texel : mapSoftness(shadow, bundle.end, width);
    const thinnest = isSoft ? edge : 0;
    const met = this.isMet(bundle, MIDDLE, 0, 0, lift)
      ? MIDDLE
      : isSoft && DISC.slice(0, RIM).find((place) => this.isMet(bundle, place, thinnest, opening, lift));
    if (!met) return LIT;
    const reach = Math.min(width / Math.max(fade, 1 / FARTHEST_CASTER), TOWARDS_LAMP * bundle.end);
    const caster = this.casterAlong(bundle, met, met === MIDDLE ? 0 : thinnest, opening, reach);
    const left = Math.max(1 - (fade * caster) / width, 0);
    if (left === 0 || !isSoft) return shadowWith(0, left);
    // The edge is at least as wide as that of the map.
    return shadowWith(this.passing(bundle, Math.max(thinnest - opening * caster, 0), opening, lift), left);
  }

  /** The visible share of a lamp, by rays that start within a spread around a place and open towards the lamp. */
  private passing(bundle: Bundle, spread: number, opening: number, lift: number): number {
    const isDark = this.isMet(bundle, MIDDLE, 0, 0, lift);
    let met = 0;
    for (let i = 0; i < RAYS; i++) {
      if (i === RIM && met === (isDark ? RIM : 0)) return isDark ? 0 : 1;
      if (this.isMet(bundle, DISC[i], spread, opening, lift)) met++;
    }
    return 1 - met / RAYS;
  }

  private isMet(bundle: Bundle, on: readonly [number, number], spread: number, opening: number, lift: number): boolean {
    this.aim(bundle, on, spread, opening);
    return this.bvh.isShaded(this.from, this.way, lift, bundle.end);
  }

  /** The distance along a ray of the first occluder, as seen from the light, up to a reach. */
  private casterAlong(
    bundle: Bundle,
    on: readonly [number, number],
    spread: number,
    opening: number,
    reach: number,
  ): number {
    this.aim(bundle, on, spread, opening);
    const { from, way } = this;
    if (reach < bundle.end && this.bvh.isShaded(from, way, reach, bundle.end)) return reach;
    const met = this.bvh.firstCaster(combined(1, from, reach, way), combined(-1, way, 0, way), reach);
    return met < reach ? reach - met : 0;
  }

  /** Sets the ray to the one through a point on the disc. */
  private aim(
    { from, towards, end, side, up, besides, above }: Bundle,
    on: readonly [number, number],
    spread: number,
    opening: number,
  ): void {
    const [x, y] = on;
    for (let k = 0; k < 3; k++) {
      const start = spread * x * besides[k] + spread * y * above[k];
      const aside = opening * x * side[k] + opening * y * up[k];
      this.from[k] = on === MIDDLE ? from[k] : from[k] + start;
      // All rays aim at the same lamp, wherever they start.
      this.way[k] = on === MIDDLE ? towards[k] : towards[k] + aside + (-1 / end) * start;
    }
  }
}

/** The width of a map across the light at a place, world units. */
function widthAt({ cone }: Lamp, { width, isCube }: LampShadow, direction: Vec3, length: number): number {
  if (isCube) return 2 * length * Math.max(...direction.map(Math.abs));
  return length < Infinity && cone ? width * length * dot(direction, cone.axis) : width;
}

/** The softness of a map's edges, as the radius of a disc, world units. */
const mapSoftness = ({ isCube, radius, texels }: LampShadow, length: number, width: number): number =>
  // The kernel of a cube map steps through directions, where a texel spans two units.
  isCube ? (kernelRadius(radius, 2) * length) / texels : (kernelRadius(radius, 1) * width) / texels;
