import type { MaterialParameters, NormalMapTypes } from 'three';
import type { PresetName } from '../look/presetMaterials.js';
import type { SceneExtent } from './fading/SceneExtent.js';
import type { HatchingMaterialOptions } from './HatchingMaterialProperties.js';

/** What `new HatchingMaterial()` and `setValues()` take. */
export type HatchingMaterialParameters = MaterialParameters &
  Partial<HatchingMaterialOptions> & {
    /** The preset to start from, by its name. The other parameters override it one by one, and what it does not name is at its default. */
    preset?: PresetName | undefined;
    /** Defines of your own, beside the material's. */
    defines?: Record<string, unknown> | undefined;
    /** The space of `normalMap`: `TangentSpaceNormalMap`, the default, or `ObjectSpaceNormalMap`. */
    normalMapType?: NormalMapTypes | undefined;
    /** How far the scene reaches, by which `depthFade` measures depth. */
    extent?: SceneExtent | null | undefined;
    fog?: boolean | undefined;
    wireframe?: boolean | undefined;
    clipping?: boolean | undefined;
    lights?: boolean | undefined;
  };
