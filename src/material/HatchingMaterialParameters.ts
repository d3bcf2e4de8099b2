import type { MaterialParameters } from 'three';
import type { HatchingMaterialOptions } from './HatchingMaterialProperties.js';

/** What `new HatchingMaterial()` and `setValues()` take. */
export type HatchingMaterialParameters = MaterialParameters &
  Partial<HatchingMaterialOptions> & {
    /** Defines of your own, beside the material's. */
    defines?: Record<string, unknown> | undefined;
    fog?: boolean | undefined;
    wireframe?: boolean | undefined;
    clipping?: boolean | undefined;
    lights?: boolean | undefined;
  };
