import { DataTexture, DataUtils, HalfFloatType, LinearFilter, type Material, RGFormat } from 'three';
import type { Hand } from '../../strokes/hand/Hand.js';
import { HAND_TEXTURE } from '../../strokes/handConstants.js';
import { type StrokeProfiles, strokeProfiles } from '../../strokes/strokeProfiles.js';
import { warn } from '../diagnostics/warn.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';

const { PLACES, HAND_ROWS, TONE_ROWS } = HAND_TEXTURE;

/** The strokes of a hand on the graphics card, for all materials that draw with it. */
interface DrawnHand {
  readonly texture: DataTexture;
  readonly profiles: StrokeProfiles;
  users: number;
}

/** One texture of 32 kB for each hand that materials draw with. It is freed with the last of them. */
export class HandTextures {
  private readonly drawn = new WeakMap<Hand, DrawnHand>();
  /** The hand of each material. */
  private readonly chosen = new WeakMap<Material, Hand>();
  /** The strokes of the hand that was last checked, until they are drawn. */
  private checked: { readonly hand: Hand; readonly profiles: StrokeProfiles } | null = null;

  /**
   * The strokes of a hand. Those of one that is not drawn yet are kept until it is, or until another is asked for.
   *
   * @throws TypeError or RangeError with the fault of the hand
   */
  profilesOf(hand: Hand): StrokeProfiles {
    const drawn = this.drawn.get(hand);
    if (drawn) return drawn.profiles;
    if (this.checked?.hand !== hand) this.checked = { hand, profiles: strokeProfiles(hand) };
    return this.checked.profiles;
  }

  /**
   * The strokes of the hand that a material draws with from now on. Where nothing else draws with the hand before it, its texture is
   * written anew. A hand with a fault, which is reported, leaves the material the hand before it, or none.
   */
  use(material: HatchingMaterialProperties, hand: Hand): DrawnHand | undefined {
    try {
      return this.chosenBy(material, hand);
    } catch (error) {
      const before = this.chosen.get(material) ?? null;
      const instead = before ? 'The hand before it stays.' : 'The strokes are those of the technique "pen".';
      warn(`${(error as Error).message} ${instead}`, 'error');
      material.hand = before;
      return undefined;
    }
  }

  private chosenBy(material: Material, hand: Hand): DrawnHand {
    const before = this.chosen.get(material);
    const known = this.drawn.get(hand);
    if (before === hand && known) return known;
    const profiles = this.profilesOf(hand);
    this.checked = null;
    if (before === undefined) material.addEventListener('dispose', this.release);
    const left = before && this.leave(before);
    const texture = known?.texture ?? left ?? newTexture();
    if (left && left !== texture) left.dispose();
    if (!known) write(texture, profiles);
    const next = known ?? { texture, profiles, users: 0 };
    next.users++;
    this.drawn.set(hand, next);
    this.chosen.set(material, hand);
    return next;
  }

  /** Frees what a material draws with, if no other material does. */
  private readonly release = ({ target: material }: { target: Material }): void => {
    material.removeEventListener('dispose', this.release);
    const hand = this.chosen.get(material);
    this.chosen.delete(material);
    if (hand) this.leave(hand)?.dispose();
  };

  /** @returns the texture of the hand if no material draws with it any longer */
  private leave(hand: Hand): DataTexture | undefined {
    const drawn = this.drawn.get(hand);
    if (!drawn || --drawn.users > 0) return undefined;
    this.drawn.delete(hand);
    return drawn.texture;
  }
}

function newTexture(): DataTexture {
  const texture = new DataTexture(new Uint16Array(2 * PLACES * HAND_ROWS), PLACES, HAND_ROWS, RGFormat, HalfFloatType);
  texture.magFilter = texture.minFilter = LinearFilter;
  return texture;
}

/** Strokes in the first rows, and how tones are drawn in the last. */
function write(texture: DataTexture, { strokes, tones }: StrokeProfiles): void {
  const data = texture.image.data as unknown as Uint16Array;
  for (let i = 0; i < strokes.length; i++) data[i] = DataUtils.toHalfFloat(strokes[i]);
  let at = 2 * PLACES * (HAND_ROWS - TONE_ROWS);
  for (const { share, widening } of tones.flat()) {
    data[at++] = DataUtils.toHalfFloat(share);
    data[at++] = DataUtils.toHalfFloat(widening);
  }
  texture.needsUpdate = true;
}
