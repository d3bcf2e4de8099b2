import { type Color, Material, type Mesh, type NormalMapTypes, type Texture, type Vector2 } from 'three';
import { GLASS } from '../look/glass.js';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import type { HatchingMaterialParameters } from '../material/checkValues.js';
import { deforms } from '../material/deformation/canDeform.js';
import type { SceneExtent } from '../material/fading/SceneExtent.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { isReplaced } from './leftAlone.js';

/** The number of digits in which equal scales agree; further ones may differ by rounding. */
const SCALE_DIGITS = 6;

/**
 * Makes the hatching materials of a scene: one for each source material and scale of the meshes that use it. Meshes that deform get
 * materials of their own, because they need another program.
 */
export class MaterialReplacer {
  readonly materials: HatchingMaterial[] = [];
  /** Copy changes from the materials that were replaced. */
  readonly followers: MaterialFollower[] = [];
  /** Keyed by the source, the scale, and whether the mesh deforms. */
  private readonly replacements = new Map<string, HatchingMaterial>();
  /** The scales of materials whose parameters set no `tilesPerObjectUnit`. */
  private readonly scales = new Map<HatchingMaterial, number>();

  constructor(
    private readonly parameters:
      | HatchingMaterialParameters
      | ((source: Material, mesh: Mesh) => HatchingMaterialParameters),
    private readonly make: () => HatchingMaterial,
  ) {}

  /**
   * The material or materials that replace those of a mesh, made on first use.
   *
   * @param old the material or materials of the mesh
   * @param scale world units per unit of the mesh's object space
   */
  replacementFor(mesh: Mesh, old: Material | Material[], scale: number): Material | Material[] {
    const replace = (source: Material | null | undefined): Material =>
      source && isReplaced(source, mesh) ? this.hatchingMaterialFor(source, mesh, scale) : source!;
    return Array.isArray(old) ? old.map(replace) : replace(old);
  }

  /** Gives strokes the same size in world space, on all materials whose parameters set no `tilesPerObjectUnit`. */
  setTilesPerUnit(tilesPerWorldUnit: number): void {
    for (const [material, scale] of this.scales) material.tilesPerObjectUnit = tilesPerWorldUnit * scale;
  }

  /** Sets the extent of the scene on all materials whose parameters set none. */
  setExtent(extent: SceneExtent): void {
    for (const material of this.materials) material.extent ??= extent;
  }

  dispose(): void {
    for (const material of this.materials) material.dispose();
  }

  private hatchingMaterialFor(source: Material, mesh: Mesh, scale: number): HatchingMaterial {
    const key = `${source.uuid} ${scale.toPrecision(SCALE_DIGITS)} ${deforms(mesh.geometry, mesh)}`;
    let material = this.replacements.get(key);
    if (!material) {
      const parameters = typeof this.parameters === 'function' ? this.parameters(source, mesh) : this.parameters;
      material = hatchingMaterialFrom(source, parameters, this.make());
      this.replacements.set(key, material);
      this.materials.push(material);
      this.followers.push(new MaterialFollower(source, material, Object.keys(parameters)));
      if (parameters.tilesPerObjectUnit === undefined) this.scales.set(material, scale);
    }
    return material;
  }
}

/** The properties of three's surface materials beyond those of `Material`. Other materials may have some of them. */
interface SurfaceMaterial extends Material {
  color?: Color;
  map?: Texture | null;
  alphaMap?: Texture | null;
  normalMap?: Texture | null;
  normalMapType?: NormalMapTypes;
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
  fog?: boolean;
  wireframe?: boolean;
  wireframeLinewidth?: number;
  transmission?: number;
  transmissionMap?: Texture | null;
}

/** The properties of surfaces that a hatching material has under the same name, and whose values it shares. */
const surfaceProperties = [
  'map',
  'alphaMap',
  'normalMap',
  'normalMapType',
  'bumpMap',
  'bumpScale',
  'flatShading',
  'aoMap',
  'aoMapIntensity',
  'lightMap',
  'lightMapIntensity',
  'emissiveIntensity',
  'emissiveMap',
] as const satisfies (keyof SurfaceMaterial)[];

/**
 * Turns a new hatching material into the one that replaces `source`. It takes over colour, maps and their settings (the textures are
 * shared, not copied), emission, opacity, sides, vertex colours, depth, blending, stencil, clipping, fog, wireframe, name, visibility
 * and user data. A material with `transmission` is drawn as glass, which hides nothing behind it.
 *
 * @param parameters override the values of `source`
 */
function hatchingMaterialFrom(
  source: Material,
  parameters: HatchingMaterialParameters,
  material: HatchingMaterial,
): HatchingMaterial {
  // Material.copy clones user data through JSON, which loses some values.
  Material.prototype.copy.call(material, Object.create(source, { userData: { value: {} } }));
  material.toneMapped = false;
  material.userData = { ...source.userData };
  // The planes are shared, so that moving them keeps clipping both materials.
  material.clippingPlanes = source.clippingPlanes;
  const surface: SurfaceMaterial = source;
  const { color, emissive, normalScale, fog, wireframe, wireframeLinewidth } = surface;
  if (color) material.color.copy(color);
  if (emissive) material.emissive.copy(emissive);
  if (normalScale) material.normalScale.copy(normalScale);
  for (const name of surfaceProperties) {
    if (surface[name] !== undefined) Object.assign(material, { [name]: acceptable(name, surface) });
  }
  material.fog = fog ?? true;
  material.wireframe = wireframe ?? false;
  material.wireframeLinewidth = wireframeLinewidth ?? 1;
  material.setValues(parameters);
  const { transmission = 0, transmissionMap } = surface;
  if (transmission > 0 && !transmissionMap)
    Object.assign(
      material,
      GLASS,
      { paperOpacity: 1 - Math.min(transmission, 1) },
      parameters.paperOpacity !== undefined && { paperOpacity: parameters.paperOpacity },
    );
  return material;
}

const warned = new Set<string>();

/**
 * The value of a property in the range of a hatching material. three.js also draws with numbers out of range, such as an
 * `emissiveIntensity` of −1: they are clamped, and NaN becomes the default. One warning reports it.
 */
function acceptable(name: keyof SurfaceMaterial, source: SurfaceMaterial): unknown {
  const value = source[name];
  const property = Object.hasOwn(HATCHING_PROPERTIES, name)
    ? (HATCHING_PROPERTIES[name as HatchingPropertyName] as HatchingProperty)
    : null;
  if (property?.kind === 'switch') return Boolean(value);
  if (property?.kind !== 'number') return value;
  const { from = -Infinity, to = Infinity } = property.range ?? {};
  const taken = Number.isFinite(value)
    ? Math.min(Math.max(value as number, from), to)
    : HATCHING_DEFAULTS[name as HatchingPropertyName];
  if (taken !== value && !warned.has(name)) {
    warned.add(name);
    console.warn(
      `applyHatching: ${name} is ${value} on the ${source.type}${source.name ? ` "${source.name}"` : ''}, and is hatched as ${taken}.`,
    );
  }
  return taken;
}

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
