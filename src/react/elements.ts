import { extend, invalidate, type ThreeElement } from '@react-three/fiber';
import {
  type HatchingComposition,
  type HatchingCompositionOptions,
  HatchingMaterial,
  type HatchingMaterialOptions,
  type HatchingMaterialParameters,
  type HatchingOutlineMaterial,
  type HatchingOutlineParameters,
  type HatchingOutlines,
  type HatchingShadowMaterial,
} from 'three-hatching';

/** Whose composition it is by its making. */
const madeBy = new WeakMap<HatchingComposition, object>();

/** Whether it belongs to a material that no element stands for, as the one from which React Three Fiber reads what a removed prop goes back to. */
function isBlank(composition: FollowedMaterial['composition']): boolean {
  const owner = madeBy.get(composition);
  return owner !== undefined && !('__r3f' in owner);
}

/**
 * The material of `<hatchingMaterial>`: it requests a frame when its map and its code have loaded, for a canvas with
 * `frameloop="demand"`.
 */
export class FollowedMaterial extends HatchingMaterial {
  /** The properties at the last draw that decide which map and which code are needed. */
  private followed: Partial<Pick<HatchingMaterial, 'tonalArtMap' | 'technique' | 'hand'>> = {};
  /** The numbers that the arguments gave the composition, such as those of a preset. */
  private readonly composedFirst: HatchingComposition;

  // React Three Fiber resets a removed prop only if the constructor's `length` is 0.
  constructor(parameters: HatchingMaterialParameters | undefined = undefined) {
    super(parameters);
    this.composedFirst = this.composition.clone();
    if (!madeBy.has(this.composition)) madeBy.set(this.composition, this);
  }

  override get composition(): HatchingComposition {
    return super.composition;
  }

  override set composition(value: HatchingComposition | Partial<HatchingCompositionOptions>) {
    super.composition = isBlank(value as HatchingComposition) ? this.composedFirst.clone() : value;
  }

  // The hook of HatchingMaterial runs before this one, as before any hook that a user sets.
  override onBeforeRender(): void {
    const { followed } = this;
    const { tonalArtMap, technique, hand } = this;
    if (followed.tonalArtMap === tonalArtMap && followed.technique === technique && followed.hand === hand) return;
    this.followed = { tonalArtMap, technique, hand };
    // Failures to draw the map or to fetch the code are reported by the library.
    this.ready.then(() => invalidate()).catch(() => {});
  }
}

/** The props of a material, of which those that own properties may be plain objects of some of them. */
type WithOwners<Props> = Omit<Props, 'composition' | 'perTriangle'> &
  Partial<Pick<HatchingMaterialOptions, 'composition' | 'perTriangle'>>;

declare module '@react-three/fiber' {
  interface ThreeElements {
    /** A `HatchingMaterial`. Every property is a prop. */
    hatchingMaterial: WithOwners<ThreeElement<typeof HatchingMaterial>>;
    /** A `HatchingShadowMaterial`, after `extend({ HatchingShadowMaterial })`. */
    hatchingShadowMaterial: WithOwners<ThreeElement<typeof HatchingShadowMaterial>>;
    /**
     * The `HatchingOutlines` of the parent mesh, after `extend({ HatchingOutlines })`. With `<HatchingOutlines>`, which needs no `extend`,
     * the properties of the outlines are props.
     */
    hatchingOutlines: ThreeElement<typeof HatchingOutlines>;
    /** A `HatchingOutlineMaterial`, which several outlines may share, after `extend({ HatchingOutlineMaterial })`. */
    hatchingOutlineMaterial: Omit<ThreeElement<typeof HatchingOutlineMaterial>, 'weights'> &
      Pick<HatchingOutlineParameters, 'weights'>;
  }
}

// Not the outlines: an app that draws none of its own need not load them.
extend({ HatchingMaterial: FollowedMaterial });
