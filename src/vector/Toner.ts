import { arriving, type Lamp, responseTo, seenBehind, type ToneModel } from '../engraving/radiance.js';
import { openToLights, openToSky, shadedTone, type ToneLook } from '../engraving/tone.js';
import { combined, normalize, type Vec3 } from '../engraving/vectors.js';
import type { Bvh } from './Bvh.js';
import type { SurfacePlace } from './LineSurface.js';
import type { Projection } from './Projection.js';

/** How a surface shows the light. */
export interface SurfaceLook extends ToneLook {
  model: ToneModel;
  shininess: number;
  /** Share of each light that the surroundings throw back. */
  reflectedLight: number;
  /** Luminance that the surface gives off. */
  emitted: number;
  receivesShadows: boolean;
}

/** The lights of a scene. */
export interface Illumination {
  lamps: readonly Lamp[];
  /** The radiance of a white surface with a normal under the light from all around. World space. */
  around(normal: Vec3): number;
  /** How far the places that rays of shadows begin at are lifted from the surface, world units. */
  bias: number;
}

/** The tone at a place. */
export interface Tones {
  tone: number;
  /** As if nothing cast shadows. */
  unshadowed: number;
  /** Which of the lamps do not arrive, as bits: the same all over one part of a shadow. */
  shadows: number;
}

/** What shadows are taken for: what rays say, none at all, or those of every lamp. */
export type Shadowing = 'traced' | 'none' | 'all';

/** Farther than any light. */
const FAR = 1e9;

/** Works out the tone of a surface under the lights of a scene. */
export class Toner {
  constructor(
    private readonly look: SurfaceLook,
    private readonly light: Illumination,
    private readonly bvh: Bvh,
    private readonly projection: Projection,
  ) {}

  /** Whether shadows may fall on the surface at all. */
  get hasShadows(): boolean {
    return this.look.receivesShadows && this.light.lamps.some(({ castsShadow }) => castsShadow);
  }

  read({ world, toneNormal, occlusion: occluded, paint }: SurfacePlace, shadowing: Shadowing): Tones {
    const { look, projection } = this;
    const { eye, backwards, isOrthographic } = projection;
    const toViewer = isOrthographic ? backwards : normalize(combined(1, eye, -1, world));
    let direct = 0;
    let shadowed = 0;
    let reflected = 0;
    let shadows = 0;
    for (const [i, lamp] of this.light.lamps.entries()) {
      const { direction, length, luminance, coneless } = arriving(lamp, world);
      reflected += coneless * seenBehind(toneNormal, direction);
      const sent = luminance * responseTo(look.model, toneNormal, direction, toViewer, look.shininess);
      if (sent <= 0) continue;
      if (this.isShaded(lamp, world, toneNormal, direction, length, shadowing)) {
        shadowed += sent;
        shadows |= 1 << (i % 31);
      } else direct += sent;
    }
    const open = openToLights(occluded, look.occlusion) / Math.PI;
    const sky = openToSky(occluded, look.occlusion);
    const plain = this.light.around(toneNormal);
    const around = paint ? paint.open * (plain + paint.around) : plain;
    const emitted = paint?.emitted ?? look.emitted;
    const rest = sky * (around + (look.reflectedLight * reflected) / Math.PI) + emitted;
    const painted = paint ? { ...look, darkness: paint.darkness } : look;
    const tone = shadedTone(open * direct + rest, occluded, painted);
    const unshadowed = shadowed > 0 ? shadedTone(open * (direct + shadowed) + rest, occluded, painted) : tone;
    return { tone, unshadowed, shadows };
  }

  private isShaded(
    { castsShadow }: Lamp,
    world: Vec3,
    normal: Vec3,
    direction: Vec3,
    length: number,
    shadowing: Shadowing,
  ): boolean {
    if (!castsShadow || !this.look.receivesShadows || shadowing === 'none') return false;
    if (shadowing === 'all') return true;
    const { bias } = this.light;
    return this.bvh.isShaded(combined(1, world, bias, normal), direction, 0, Math.min(length, FAR));
  }
}
