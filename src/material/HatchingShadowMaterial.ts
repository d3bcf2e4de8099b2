import type { ShaderMaterial, Texture } from 'three';
import type { HatchingShadowProperties } from './groups/ownedProperties.js';
import { CLEAR, defineShadows, type HatchingShadowMaterialParameters, withPresetShadow } from './groups/shadows.js';
import { HatchingMaterial } from './HatchingMaterial.js';
import type { HatchingMaterialJSON } from './hatchingJSON.js';
import type { ShaderFiles } from './shaders/hatchingShaders.js';

/** The files of edges that widen and of tones that dissolve with the distance. */
const files: ShaderFiles = import.meta.glob('./chunks/{softShadows,shadowSearch}.glsl', {
  base: '../../shaders',
  query: '?raw',
  import: 'default',
  eager: true,
});

/** The same with the files of each part. Equal files are one object, so that their shaders are resolved once. */
const withParts = /* @__PURE__ */ new Map<ShaderFiles, ShaderFiles>();

/**
 * A ground that shows the shadows that fall on it, hatched, and nothing else, as three's `ShadowMaterial` does. Its strokes are those of any
 * `HatchingMaterial`; what is behind it shows through between them.
 *
 * ```ts
 * const ground = new Mesh(await prepareHatchingGeometry(plane), new HatchingShadowMaterial({ preset: 'pen' }));
 * ground.receiveShadow = true;
 * ```
 */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor defines every property of the table.
export class HatchingShadowMaterial extends HatchingMaterial {
  /** @internal Left out of the declarations, as that of HatchingMaterial. */
  override readonly type: string = 'HatchingShadowMaterial';

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
   * Sets properties by name, as three's own materials do.
   *
   * @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range, before anything is set
   */
  override setValues(values?: HatchingShadowMaterialParameters): void {
    super.setValues(values && withPresetShadow(values));
  }

  /** @internal */
  protected override shaderFiles(ofPart: ShaderFiles): ShaderFiles {
    const all = withParts.get(ofPart) ?? { ...files, ...ofPart };
    withParts.set(ofPart, all);
    return all;
  }

  /** The JSON of a `HatchingMaterial`, with the properties of shadows that are not at their defaults. */
  override toJSON(meta?: Parameters<HatchingMaterial['toJSON']>[0]): ReturnType<ShaderMaterial['toJSON']> {
    // The defaults of these differ from those of other materials.
    const { transparent, paperOpacity } = this;
    return Object.assign(super.toJSON(meta), { transparent, paperOpacity });
  }

  /** Creates a material from the JSON that `toJSON` wrote, with any version of three.js. */
  static override fromJSON(
    json: HatchingMaterialJSON,
    textures: Readonly<Record<string, Texture>> = {},
  ): HatchingShadowMaterial {
    return new HatchingShadowMaterial().fromJSON(json, textures);
  }
}

export interface HatchingShadowMaterial extends HatchingShadowProperties {}
