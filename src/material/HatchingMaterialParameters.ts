import type { MaterialParameters } from 'three';
import type { HatchingMaterialOptions } from './HatchingMaterialProperties.js';

/** What `new HatchingMaterial()` and `setValues()` take. */
export type HatchingMaterialParameters = MaterialParameters &
  Partial<HatchingMaterialOptions> & {
    fog?: boolean;
    wireframe?: boolean;
    clipping?: boolean;
    lights?: boolean;
  };
