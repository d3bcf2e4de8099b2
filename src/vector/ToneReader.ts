import { TONE_CONSTANTS } from '../look/constants/shadingConstants.js';
import { relativeOcclusion } from '../look/relativeOcclusion.js';
import { radianceAround, type Surroundings } from '../look/surroundings.js';
import { combined, dot, normalize, type Vec3 } from '../look/vectors.js';
import type { Bvh } from './Bvh.js';
import type { SurfacePlace } from './LineSurface.js';
import { fadedPlace, type Projection } from './Projection.js';
import { type LampShadow, LIT, type ReceivedShadow, SHADED, ShadowRays } from './ShadowRays.js';
import { fadingAt, type ObjectFading } from './shading/fading.js';
import { type GroundLook, groundTone } from './shading/groundShadow.js';
import { mirroredRoom } from './shading/metal.js';
import { arriving, type Lamp, reflectedTo, responseTo, type ToneModel } from './shading/radiance.js';
import { openToLights, openToSky, shadedTone, type ToneLook } from './shading/tone.js';

/** The response of a surface to light. */
export interface SurfaceLook extends ToneLook {
  model: ToneModel;
  shininess: number;
  /** Share of each light that the surroundings reflect. */
  reflectedLight: number;
  /** Emitted luminance. */
  emitted: number;
  /** Share of the tone that a mirrored room decides, on metal. */
  mirrored: number;
  receivesShadows: boolean;
  /** The look of a ground that shows shadows alone; null for bodies. */
  ground: GroundLook | null;
  /** The share of their tone that see-through surfaces print; 1 for others. */
  opacity: number;
  /** Null where everything has its full weight. */
  fading: ObjectFading | null;
}

/** The lights of a scene. */
export interface Illumination {
  lamps: readonly Lamp[];
  /** The shadow of each lamp; null for lamps without one. */
  shadows: readonly (LampShadow | null)[];
  /** Whether shadows are as soft as on the canvas, or hard. */
  isSoft: boolean;
  around: Surroundings;
  /** Height above the surface at which shadow rays start, world units. */
  bias: number;
}

/** The tones at a place. */
export interface Tones {
  tone: number;
  /** Without shadows. */
  unshadowed: number;
  /** The lamps that do not arrive, as bits: constant over one part of a shadow. In soft edges each bit counts by its share. */
  shadows: number;
  /** The share of the shadow on a ground that has not dissolved; 1 on bodies. */
  left: number;
  /** The tone of a full shadow on a ground; 0 on bodies. */
  full: number;
  /** The lamps that are shadowed so much that lines turn, as bits. */
  turned: number;
  /** The lamps that do not arrive at all, as bits; `IN_EDGE` where one arrives in part. */
  dark: number;
}

/** Where a lamp arrives in part. */
export const IN_EDGE = -1;

/** Which shadows to assume: traced by rays, each by one ray, none, or those of all lamps. */
export type Shadowing = 'traced' | 'hard' | 'none' | 'all';

const { LEAST_RESPONSE } = TONE_CONSTANTS;

/** Computes the tone of a surface under the lights of a scene. */
export class ToneReader {
  private readonly rays: ShadowRays;
  /** The look with the darkness of the paint at the last place. */
  private readonly painted: SurfaceLook;

  constructor(
    private readonly look: SurfaceLook,
    private readonly light: Illumination,
    bvh: Bvh,
    private readonly projection: Projection,
  ) {
    this.painted = { ...look };
    this.rays = new ShadowRays(bvh, light.bias, light.isSoft);
  }

  /** Whether the surface shows shadows alone. */
  get isGround(): boolean {
    return this.look.ground !== null;
  }

  /** Whether shadows are traced by many rays. */
  get hasSoftShadows(): boolean {
    return this.light.isSoft && this.hasShadows;
  }

  /** The shadows with the most ink; with light ink none. */
  get darkest(): Shadowing {
    const [blank, full] = this.look.toneEnds;
    return full >= blank ? 'all' : 'none';
  }

  /** Whether the surface may receive shadows. */
  get hasShadows(): boolean {
    return this.look.receivesShadows && this.light.lamps.some(({ castsShadow }) => castsShadow);
  }

  read({ world, toneNormal, isPlane, occlusion, paint }: SurfacePlace, shadowing: Shadowing): Tones {
    const { look, projection } = this;
    const occluded = relativeOcclusion(occlusion, look.openOcclusion);
    const toViewer = this.toViewerFrom(world);
    let direct = 0;
    let shadowed = 0;
    let reflected = 0;
    let shadows = 0;
    let taken = 0;
    let lost = 0;
    let turned = 0;
    let dark = 0;
    const { lamps } = this.light;
    for (let i = 0; i < lamps.length; i++) {
      const lamp = lamps[i];
      const { direction, length, luminance, coneless } = arriving(lamp, world);
      reflected += coneless * reflectedTo(toneNormal, direction, isPlane && !look.ground);
      const sent = luminance * responseTo(look.model, toneNormal, direction, toViewer, look.shininess);
      if (sent <= 0) continue;
      const place = { world, normal: toneNormal, direction, length };
      const { passing, left, isEdge } = this.shadowOf(i, place, shadowing);
      if (isEdge || dark === IN_EDGE) dark = IN_EDGE;
      else if (passing < 1) dark |= 1 << (i % 31);
      direct += passing * sent;
      shadowed += (1 - passing) * sent;
      shadows += (1 - passing) * left * 2 ** (i % 31);
      const facing = Math.max(dot(toneNormal, direction), 0);
      if (facing * (1 - 2 * passing) > LEAST_RESPONSE) turned |= 1 << (i % 31);
      const takes = (1 - passing) * luminance * facing;
      taken += takes;
      lost += (1 - left) * takes;
    }
    const open = openToLights(occluded, look.occlusion) / Math.PI;
    const sky = openToSky(occluded, look.occlusion);
    const plain = radianceAround(this.light.around, ...toneNormal);
    const around = paint ? paint.open * (plain + paint.around) : plain;
    const emitted = paint?.emitted ?? look.emitted;
    const rest = sky * (around + (look.reflectedLight * reflected) / Math.PI) + emitted;
    const { painted } = this;
    painted.darkness = paint ? paint.darkness : look.darkness;
    const faded = look.fading === null ? 1 : fadingAt(look.fading, fadedPlace(world, projection));
    const weight = look.opacity * faded;
    const left = taken > 0 ? 1 - lost / taken : 1;
    if (look.ground) {
      const tone = weight * groundTone(open * direct + rest, open * shadowed, left, look, look.ground);
      return { tone, unshadowed: 0, shadows, left, full: look.toneEnds[1] * look.ground.tone * left, turned, dark };
    }
    const share = look.mirrored;
    const mirror = share > 0 ? { room: mirroredRoom(toneNormal, toViewer), share } : undefined;
    const toneOf = (radiance: number): number => weight * shadedTone(radiance, occluded, painted, mirror);
    const tone = toneOf(open * direct + rest);
    const unshadowed = shadowed > 0 ? toneOf(open * (direct + shadowed) + rest) : tone;
    return { tone, unshadowed, shadows, left: 1, full: 0, turned, dark };
  }

  /** The lamps that do not arrive at a place, as bits, by one ray to each: `dark` of its tones outside of soft edges. */
  darkAt({ world, toneNormal }: SurfacePlace): number {
    if (!this.hasShadows) return 0;
    const { look } = this;
    const toViewer = this.toViewerFrom(world);
    let dark = 0;
    for (const [i, lamp] of this.light.lamps.entries()) {
      if (!this.light.shadows[i] || !lamp.castsShadow) continue;
      const { direction, length, luminance } = arriving(lamp, world);
      if (luminance * responseTo(look.model, toneNormal, direction, toViewer, look.shininess) <= 0) continue;
      const place = { world, normal: toneNormal, direction, length };
      if (this.shadowOf(i, place, 'hard').passing < 1) dark |= 1 << (i % 31);
    }
    return dark;
  }

  /**
   * The share of the light of all lamps that cast shadows which these take at a step from a place, with hard edges.
   *
   * @param step view space
   */
  takenAt({ world, toneNormal }: SurfacePlace, step: Vec3): number {
    const { look, projection } = this;
    const there = projection.stepped(world, step);
    const toViewer = this.toViewerFrom(world);
    let sum = 0;
    let taken = 0;
    for (const [i, lamp] of this.light.lamps.entries()) {
      const shadow = this.light.shadows[i];
      if (!shadow || !lamp.castsShadow) continue;
      const { direction, luminance } = arriving(lamp, world);
      const sent = luminance * responseTo(look.model, toneNormal, direction, toViewer, look.shininess);
      if (sent <= 0) continue;
      const from = arriving(lamp, there);
      const place = { world: there, normal: toneNormal, direction: from.direction, length: from.length };
      sum += sent;
      taken += sent * (1 - this.rays.hardPassing(shadow, place));
    }
    return sum > 0 ? taken / sum : 0;
  }

  private toViewerFrom(world: Vec3): Vec3 {
    const { eye, backwards, isOrthographic } = this.projection;
    return isOrthographic ? backwards : normalize(combined(1, eye, -1, world));
  }

  private shadowOf(
    i: number,
    place: { world: Vec3; normal: Vec3; direction: Vec3; length: number },
    shadowing: Shadowing,
  ): ReceivedShadow {
    const lamp = this.light.lamps[i];
    const shadow = this.light.shadows[i];
    if (!shadow || !lamp.castsShadow || !this.look.receivesShadows || shadowing === 'none') return LIT;
    if (shadowing === 'all') return SHADED;
    const isSoft = shadowing === 'hard' ? false : this.light.isSoft;
    return this.rays.shadowOf(lamp, shadow, place, this.look.ground, isSoft);
  }
}

/** Caches the tones of vertices of a body, which all families of a surface share. */
export class VertexTones {
  private readonly known: Tones[] = [];

  constructor(private readonly toneReader: ToneReader) {}

  /** The tones of a vertex. place: of the vertex, for the case that it was not read yet. */
  at(vertex: number, place: SurfacePlace): Tones {
    this.known[vertex] ??= this.toneReader.read(place, this.toneReader.hasShadows ? 'traced' : 'none');
    return this.known[vertex];
  }
}
