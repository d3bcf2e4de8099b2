import type { MaterialParameters, NormalMapTypes } from 'three';
import type { PresetName } from '../look/presetMaterials.js';
import type { SceneExtent } from './fading/SceneExtent.js';
import type { HatchingMaterialOptions } from './HatchingMaterialProperties.js';

/** The parameters of `new HatchingMaterial()` and `setValues()`. */
export type HatchingMaterialParameters = MaterialParameters &
  Partial<HatchingMaterialOptions> & {
    /**
     * The name of the preset to start from. The other parameters override it one by one; properties that the preset does not set have
     * their defaults.
     */
    preset?: PresetName | undefined;
    /** Defines of your own, added to those of the material. */
    defines?: Record<string, unknown> | undefined;
    /** The space of `normalMap`: `TangentSpaceNormalMap`, the default, or `ObjectSpaceNormalMap`. */
    normalMapType?: NormalMapTypes | undefined;
    /** The extent of the scene, relative to which `depthFade` measures depth. */
    extent?: SceneExtent | null | undefined;
    fog?: boolean | undefined;
    wireframe?: boolean | undefined;
    clipping?: boolean | undefined;
    lights?: boolean | undefined;
  };
