import type { Color, Material, Texture, Vector2 } from 'three';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';

/** The properties of three's surface materials beyond those of `Material`. Other materials may have some of them. */
export interface SurfaceMaterial extends Material {
  color?: Color;
  map?: Texture | null;
  alphaMap?: Texture | null;
  normalMap?: Texture | null;
  normalMapType?: HatchingMaterial['normalMapType'];
  normalScale?: Vector2;
  bumpMap?: Texture | null;
  bumpScale?: number;
  flatShading?: boolean;
  aoMap?: Texture | null;
  aoMapIntensity?: number;
  lightMap?: Texture | null;
  lightMapIntensity?: number;
  emissive?: Color;
  emissiveIntensity?: number;
  emissiveMap?: Texture | null;
  metalness?: number;
  metalnessMap?: Texture | null;
  roughness?: number;
  roughnessMap?: Texture | null;
  fog?: boolean;
  wireframe?: boolean;
  wireframeLinewidth?: number;
  transmission?: number;
  transmissionMap?: Texture | null;
}
