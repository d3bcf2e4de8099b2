import type { HatchingShadowProperties } from '../material/groups/ownedProperties.js';
import {
  CLEAR,
  defineShadows,
  type HatchingShadowMaterialParameters,
  withPresetShadow,
} from '../material/groups/shadows.js';
import { HatchingNodeMaterial } from './HatchingNodeMaterial.js';

/** `HatchingShadowMaterial` for WebGPURenderer, experimental: a ground that shows the shadows that fall on it, and nothing else. */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor defines every property of the table.
export class HatchingShadowNodeMaterial extends HatchingNodeMaterial {
  static override get type(): string {
    return 'HatchingShadowNodeMaterial';
  }

  /** @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range */
  constructor(parameters: HatchingShadowMaterialParameters | undefined = undefined) {
    super();
    defineShadows(this);
    this.setValues({ ...CLEAR, ...parameters });
  }

  override get isHatchingShadowMaterial(): true {
    return true;
  }

  /**
   * Sets properties by name, as three's own.
   *
   * @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range, before anything is set
   */
  override setValues(values?: HatchingShadowMaterialParameters): void {
    super.setValues(values && withPresetShadow(values));
  }
}

export interface HatchingShadowNodeMaterial extends HatchingShadowProperties {}
