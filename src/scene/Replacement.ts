import { type Color, Material, type Vector2 } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { GivenValues } from './GivenValues.js';
import { SeenValues } from './SeenValues.js';
import type { SurfaceMaterial } from './SurfaceMaterial.js';

/** The properties of surfaces that a hatching material has under the same name, and whose values it shares. */
export const surfaceProperties = [
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
  'metalness',
  'roughness',
] as const satisfies (keyof SurfaceMaterial)[];

const warned = new Set<string>();

/**
 * The value of a property in the range of a hatching material. three.js also draws with numbers out of range, such as an
 * `emissiveIntensity` of −1: they are clamped, and NaN becomes the default. One warning reports it.
 */
export function acceptable(name: keyof SurfaceMaterial, source: SurfaceMaterial): unknown {
  // Where only a map says what is metal, nothing mirrors.
  const value = name === 'metalness' && (source.metalnessMap || source.roughnessMap) ? 0 : source[name];
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

/** The properties whose values are copied. */
export const COPIED = ['color', 'emissive', 'normalScale'] as const;

type CopiedName = (typeof COPIED)[number];
type SharedName = Exclude<keyof SeenValues, 'note' | 'differFrom' | CopiedName>;

/** The properties that are copied from every material and whose values are shared. */
const sharedNames = (seen: SeenValues): SharedName[] =>
  (Object.keys(seen) as SharedName[]).filter((name) => !COPIED.includes(name as never));

/** The properties of hatching materials that a user may change. */
function editableNames(): string[] {
  const { uuid, userData, version, ...ofMaterial } = new Material() as Material & Record<string, unknown>;
  const names = Object.keys(ofMaterial).filter((name) => !/^(_|is[A-Z]|id$|type$)/.test(name));
  return [
    ...new Set([
      ...names,
      ...sharedNames(new SeenValues(new Material())),
      'wireframeLinewidth',
      'composition',
      // The technique decides the defaults of others, which must be set after it.
      'technique',
      ...Object.entries<HatchingProperty>(HATCHING_PROPERTIES).flatMap(([name, { owner }]) => {
        if (owner === 'perTriangle') return `${owner}.${name}`;
        return owner ? [] : name;
      }),
    ]),
  ];
}

let names: string[] | undefined;

/**
 * A hatching material in place of a material of the scene, its source. Changes of the source count in the next frame. A property that
 * was passed to the hatching material, or set on it since, stays.
 */
export class Replacement {
  private readonly followed: readonly SharedName[];
  private readonly followedCopies: readonly CopiedName[];
  private readonly given: GivenValues;
  private readonly last: SeenValues;
  private isFollowing = false;
  private isStarted = false;

  /**
   * @param key names the source, the scale of its meshes, and whether they deform
   * @param passed the names of the parameters that the hatching material was created with
   * @param scale world units per object unit, if the size of strokes follows from it
   */
  constructor(
    readonly key: string,
    readonly source: Material,
    public material: HatchingMaterial,
    passed: readonly string[],
    readonly scale: number | null,
  ) {
    const surface: SurfaceMaterial = source;
    this.last = new SeenValues(source);
    this.followed = sharedNames(this.last).filter((name) => surface[name] !== undefined && !passed.includes(name));
    this.followedCopies = COPIED.filter((name) => surface[name] && !passed.includes(name));
    names ??= editableNames();
    this.given = new GivenValues(material, names);
  }

  /** Sets a property, unless it was edited. */
  give(name: string, value: unknown): void {
    this.given.give(this.material, name, value);
  }

  /** Takes over what a user has changed on the material of another replacement. @param except names of properties that stay */
  takeEdits({ given, material }: Replacement, except: readonly string[]): void {
    given.copyEdits(material, this.material, except);
  }

  /** Copies the changes of the source since the last call. Allocates nothing if there are none. */
  follow(): void {
    if (this.isFollowing || !this.last.differFrom(this.source)) return;
    this.isFollowing = true;
    const { last } = this;
    const source: SurfaceMaterial = this.source;
    for (const name of this.followed) if (source[name] !== last[name]) this.give(name, acceptable(name, source));
    for (const name of this.followedCopies) {
      const value = source[name];
      if (value && !last[name].equals(value as Color & Vector2)) this.give(name, value);
    }
    last.note(source);
    this.isFollowing = false;
  }

  /**
   * Follows the source from now on. three.js reads `visible` of each material just before it puts a mesh into a render list, also while
   * it is false: that is when the source is compared.
   */
  start(): void {
    if (this.isStarted) return;
    this.isStarted = true;
    const { material } = this;
    let { visible } = material;
    Object.defineProperty(material, 'visible', {
      get: () => {
        this.follow();
        return visible;
      },
      set: (value: boolean) => {
        visible = value;
      },
      enumerable: true,
      configurable: true,
    });
  }

  /** Ends it. */
  stop(): void {
    if (!this.isStarted) return;
    this.isStarted = false;
    const { material } = this;
    this.isFollowing = true;
    Object.defineProperty(material, 'visible', {
      value: material.visible,
      writable: true,
      enumerable: true,
      configurable: true,
    });
    this.isFollowing = false;
  }

  /** Gives all values to the material of an earlier replacement, which takes the place of this one's. */
  moveTo(held: HatchingMaterial): void {
    const { material } = this;
    const { userData } = held;
    held.copy(material);
    // Material.copy clones these.
    Object.assign(held, { userData, clippingPlanes: material.clippingPlanes, needsUpdate: true });
    this.material = held;
  }
}
