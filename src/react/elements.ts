import { extend, type ThreeElement } from '@react-three/fiber';
import type { HatchingMaterial, HatchingOutlineMaterial, HatchingOutlines } from 'three-hatching';
import { FollowedMaterial } from './FollowedMaterial.js';

declare module '@react-three/fiber' {
  interface ThreeElements {
    /** A `HatchingMaterial`. Every property is a prop. */
    hatchingMaterial: ThreeElement<typeof HatchingMaterial>;
    /**
     * The `HatchingOutlines` of the parent mesh, after `extend({ HatchingOutlines })`. With `<HatchingOutlines>`, which needs no `extend`,
     * the properties of the outlines are props.
     */
    hatchingOutlines: ThreeElement<typeof HatchingOutlines>;
    /** A `HatchingOutlineMaterial`, which several outlines may share, after `extend({ HatchingOutlineMaterial })`. */
    hatchingOutlineMaterial: ThreeElement<typeof HatchingOutlineMaterial>;
  }
}

// Not the outlines: an app that draws none of its own need not load them.
extend({ HatchingMaterial: FollowedMaterial });
