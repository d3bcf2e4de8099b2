import type { ToneFit } from '../exposure/ToneFit.js';
import type { SceneExtent } from '../fading/SceneExtent.js';
import type { HatchingCompositionOptions, HatchingCompositionProperties } from './ownedProperties.js';
import { PropertyGroup } from './PropertyGroup.js';

/**
 * What counts for a whole picture: exposure, depth fade, focus and vignette. The materials of a scene share one, as three's materials share
 * the `Fog` of their scene; outlines follow that of their surface.
 *
 * Every property may be set at any time and takes effect in the next frame. None compiles another program.
 */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor defines every property of the table.
export class HatchingComposition extends PropertyGroup {
  readonly isHatchingComposition = true;

  /**
   * The extent of the scene, relative to which `depthFade` measures depth; `applyHatching` sets it. If null, depths are in world units
   * from the eye. Default: null.
   */
  extent: SceneExtent | null = null;
  private fitted: ToneFit | null = null;

  /** @throws TypeError or RangeError for a value of the wrong kind or out of its range */
  constructor(values: Partial<HatchingCompositionOptions> = {}) {
    super('composition');
    this.setValues(values);
  }

  /**
   * Sets some of the properties by name.
   *
   * @throws TypeError or RangeError for a value of the wrong kind or out of its range, before anything is set
   */
  setValues(values: Partial<HatchingCompositionOptions>): void {
    this.assign(values);
  }

  /** Fits an `exposure` of `'fit'` again, in the next frame: after lights, environment or the look of the scene have changed. */
  refit(): void {
    this.fitted = null;
  }

  /** A composition with the same numbers and the same extent. Its exposure is fitted anew. */
  clone(): HatchingComposition {
    return new HatchingComposition().copy(this);
  }

  /** Takes over the numbers and the extent of another composition. */
  copy(source: HatchingComposition): this {
    this.numbers = new Map(source.numbers);
    this.focused = source.focused?.clone() ?? null;
    this.extent = source.extent;
    this.refit();
    return this;
  }

  /** The fit that an `exposure` of `'fit'` keeps; null before it was fitted, and for other exposures. @internal */
  get keptFit(): ToneFit | null {
    return this.exposure === 'fit' ? this.fitted : null;
  }

  /** The fit to draw with: the kept one, or the given one, which an `exposure` of `'fit'` keeps. @internal */
  kept(fit: ToneFit): ToneFit {
    if (this.exposure !== 'fit') return fit;
    this.fitted ??= { ...fit };
    return this.fitted;
  }
}

export interface HatchingComposition extends HatchingCompositionProperties {}

/**
 * The composition of a material after a value was assigned to it: the given instance, or the present one with the numbers of a plain object.
 *
 * @throws TypeError or RangeError for a value of the wrong kind or out of its range
 */
export function composedWith(
  present: HatchingComposition,
  value: HatchingComposition | Partial<HatchingCompositionOptions>,
): HatchingComposition {
  if ('isHatchingComposition' in Object(value)) return value as HatchingComposition;
  present.setValues(value);
  return present;
}
