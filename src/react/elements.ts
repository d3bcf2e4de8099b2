import { extend, type ThreeElement } from '@react-three/fiber';
import { HatchingLineMaterial, HatchingLines, HatchingMaterial } from 'three-hatching';

declare module '@react-three/fiber' {
  interface ThreeElements {
    /** A `HatchingMaterial`. Every property is a prop. */
    hatchingMaterial: ThreeElement<typeof HatchingMaterial>;
    /** The `HatchingLines` of the parent mesh. With `<HatchingLines>` the properties of the lines are props. */
    hatchingLines: ThreeElement<typeof HatchingLines>;
    /** A `HatchingLineMaterial`, which several lines may share. */
    hatchingLineMaterial: ThreeElement<typeof HatchingLineMaterial>;
  }
}

extend({ HatchingMaterial, HatchingLines, HatchingLineMaterial });
