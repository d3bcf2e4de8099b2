import type { Color, Material, Vector2 } from 'three';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { acceptable, type SurfaceMaterial, surfaceProperties } from './hatchingMaterialFrom.js';

/** The properties that are copied from every material, beside those of surfaces. */
const MATERIAL_PROPERTIES = [
  'visible',
  'opacity',
  'transparent',
  'side',
  'alphaTest',
  'alphaHash',
  'blending',
  'colorWrite',
  'depthTest',
  'depthFunc',
  'depthWrite',
  'polygonOffset',
  'polygonOffsetFactor',
  'polygonOffsetUnits',
  'clippingPlanes',
  'clipIntersection',
  'alphaToCoverage',
  'stencilWrite',
  'stencilFunc',
  'stencilRef',
  'stencilFuncMask',
  'vertexColors',
  'fog',
  'wireframe',
] as const satisfies (keyof SurfaceMaterial)[];

const NAMES = [...MATERIAL_PROPERTIES, ...surfaceProperties] as const;
const COPIED = ['color', 'emissive', 'normalScale'] as const;

type Values = Record<string, unknown>;
type Copied = Color | Vector2;

/**
 * Copies changes of a material to the hatching material that has replaced it. A property that was passed to the hatching material, or
 * set on it since, stays.
 */
export class MaterialFollower {
  /** For each property, the last value in the source, and the value that the hatching material got for it. */
  private readonly seen: Values = {};
  private readonly taken: Values = {};
  private readonly seenCopies: Partial<Record<(typeof COPIED)[number], Copied>> = {};
  private readonly names: readonly (typeof NAMES)[number][];

  /** @param given the names of the parameters that the hatching material was created with */
  constructor(
    private readonly source: Material,
    private readonly material: HatchingMaterial,
    given: readonly string[],
  ) {
    const values = source as unknown as Values;
    this.names = NAMES.filter((name) => values[name] !== undefined && !given.includes(name));
    for (const name of this.names) {
      this.seen[name] = values[name];
      this.taken[name] = material[name];
    }
    for (const name of COPIED) {
      if (values[name] && !given.includes(name)) this.seenCopies[name] = (values[name] as Copied).clone();
    }
  }

  /** Copies the changes since the last call. Allocates nothing if there are none. */
  follow(): void {
    const { seen, taken } = this;
    const source = this.source as SurfaceMaterial;
    const material = this.material as unknown as Values;
    for (const name of this.names) {
      if (source[name] === seen[name]) continue;
      seen[name] = source[name];
      if (material[name] !== taken[name]) continue;
      material[name] = acceptable(name, source);
      taken[name] = material[name];
    }
    for (const name of COPIED) {
      const copy = this.seenCopies[name] as Color | undefined;
      const value = source[name] as Color | undefined;
      if (!copy || !value || copy.equals(value)) continue;
      const target = material[name] as Color;
      if (target.equals(copy)) target.copy(value);
      copy.copy(value);
    }
  }
}
