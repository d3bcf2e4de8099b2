import { extend, type ThreeElement } from '@react-three/fiber';
import { type HatchingMaterial, HatchingOutlineMaterial, HatchingOutlines } from 'three-hatching';
import { FollowedMaterial } from './FollowedMaterial.js';

declare module '@react-three/fiber' {
  interface ThreeElements {
    /** A `HatchingMaterial`. Every property is a prop. */
    hatchingMaterial: ThreeElement<typeof HatchingMaterial>;
    /** The `HatchingOutlines` of the parent mesh. With `<HatchingOutlines>` the properties of the outlines are props. */
    hatchingOutlines: ThreeElement<typeof HatchingOutlines>;
    /** A `HatchingOutlineMaterial`, which several outlines may share. */
    hatchingOutlineMaterial: ThreeElement<typeof HatchingOutlineMaterial>;
  }
}

extend({ HatchingMaterial: FollowedMaterial, HatchingOutlines, HatchingOutlineMaterial });
