import { extend, type ThreeElement } from '@react-three/fiber';
import { HatchingLineMaterial, HatchingLines, HatchingMaterial } from 'three-hatching';

declare module '@react-three/fiber' {
  interface ThreeElements {
    /** `HatchingMaterial`: every property is an attribute. */
    hatchingMaterial: ThreeElement<typeof HatchingMaterial>;
    /** `HatchingLines` of the mesh it is a child of. `<HatchingLines>` takes the properties of the lines directly. */
    hatchingLines: ThreeElement<typeof HatchingLines>;
    /** `HatchingLineMaterial`, which several lines may share. */
    hatchingLineMaterial: ThreeElement<typeof HatchingLineMaterial>;
  }
}

extend({ HatchingMaterial, HatchingLines, HatchingLineMaterial });
