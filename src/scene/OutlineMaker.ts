import type { Material, Mesh } from 'three';
import { deforms } from '../material/deformation/canDeform.js';
import { describeObject } from '../material/diagnostics/describeObject.js';
import { warn } from '../material/diagnostics/warn.js';
import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type {
  HatchingOutlineMaterial,
  HatchingOutlineParameters,
} from '../material/outlines/HatchingOutlineMaterial.js';
import type { HatchingOutlines } from '../material/outlines/HatchingOutlines.js';
import type { MeshOutlines } from '../material/outlines/MeshOutlines.js';
import { HATCHING_OUTLINE_DEFAULTS } from '../material/outlines/outlineProperties.js';
import { isCutOut } from '../material/outlines/surfaceRules.js';
import { GivenValues, namesIn } from './GivenValues.js';
import type { MeshLook } from './geometryPlans.js';
import type { SkippedMesh } from './SkippedMesh.js';
import { isBatched, isHatching, materialsOf } from './surfaceMeshes.js';

/** Whether outlines would follow the geometry, and not the visible shape that the material's cut-out or fading leaves. */
function isWiderThanSeen(material: Material & { alphaMap?: unknown }): boolean {
  const { alphaHash, alphaMap, alphaTest, transparent } = material;
  return (alphaTest > 0 || alphaHash || (transparent && Boolean(alphaMap))) && !isCutOut(material);
}

let hasWarned = false;

/** Warns once that batches have no outlines. */
function warnOfBatch(mesh: Mesh): void {
  if (hasWarned) return;
  hasWarned = true;
  warn(
    `applyHatching: the ${describeObject(mesh)} is hatched without outlines, since a BatchedMesh has none. Use an InstancedMesh or single meshes where outlines are needed.`,
  );
}

/**
 * Keeps the material of outlines blended. Code that fades all materials below an object, and then sets them opaque again, means the
 * surfaces.
 */
function alwaysBlended<Look extends Material>(material: Look): Look {
  return Object.defineProperty(material, 'transparent', {
    get: () => true,
    set: () => {},
    enumerable: true,
    configurable: true,
  });
}

/** Makes outlines for one kind of renderer. */
export interface OutlineKind<Look extends Material, Drawn> {
  /** @throws RangeError or TypeError for a wrong parameter */
  material(parameters: HatchingOutlineParameters, isDeforming: boolean): Look;
  outlines(mesh: Mesh | null, material: Look): Drawn;
}

/** The material of outlines, and the values that it was given. */
export interface OutlineLook<Look extends Material> {
  readonly material: Look;
  readonly given: GivenValues;
}

/** The properties of outline materials that a user may change. */
const EDITABLE = [...namesIn(HATCHING_OUTLINE_DEFAULTS), ...['opacity', 'visible', 'fog', 'blending', 'toneMapped']];

/**
 * Makes the outlines of a scene. Outlines share a material where their surfaces do, so that what is set on all materials of a part
 * changes nothing elsewhere.
 */
export class OutlineMaker<
  Look extends Material = HatchingOutlineMaterial,
  Drawn extends MeshOutlines = HatchingOutlines,
> {
  /** The options that decide which edges are creases. */
  readonly creases: OutlineOptions;
  private readonly parameters: HatchingOutlineParameters;
  /** The materials of outlines, by those of their surfaces. */
  readonly looks: Map<Material, OutlineLook<Look>>;
  private readonly added: Look[] = [];
  private readonly made: Drawn[] = [];
  /** The meshes that are hatched without outlines, with the reason. */
  readonly without: SkippedMesh[] = [];
  private sample: Drawn | null = null;

  /** @param known the materials of outlines that exist already */
  constructor(
    options: OutlineOptions & HatchingOutlineParameters,
    private readonly kind: OutlineKind<Look, Drawn>,
    known: ReadonlyMap<Material, OutlineLook<Look>> = new Map(),
  ) {
    const { featureAngle, creaseLength, ...parameters } = options;
    this.creases = { featureAngle, creaseLength };
    this.parameters = parameters;
    this.looks = new Map(known);
    // Wrong parameters throw here, before anything is baked.
    if (known.size === 0) this.makeSample();
  }

  /** Makes further outlines, with the same materials. */
  next(): OutlineMaker<Look, Drawn> {
    return new OutlineMaker({ ...this.creases, ...this.parameters }, this.kind, this.looks);
  }

  /**
   * Makes the outlines of a mesh whose geometry was baked, unless they would be where nothing of it is seen. They are not yet added to
   * the scene.
   */
  addOutlines({ mesh, geometry, material }: MeshLook): void {
    if (isBatched(mesh)) {
      warnOfBatch(mesh);
      this.leaveOut(mesh, 'a BatchedMesh has none');
      return;
    }
    if (materialsOf({ material }).every(isWiderThanSeen)) {
      this.leaveOut(mesh, 'they would be drawn where its picture or its opacity cuts it away');
      return;
    }
    const surface = materialsOf({ material }).find(isHatching)!;
    this.made.push(this.kind.outlines(mesh, this.materialFor(surface, deforms(geometry, mesh))));
  }

  /** Outlines without a mesh, with which the program of outlines is compiled. */
  get samples(): readonly Drawn[] {
    return [this.sample ?? this.makeSample()];
  }

  /** All outlines made so far. */
  get outlines(): readonly Drawn[] {
    return this.made;
  }

  dispose(): void {
    for (const outlines of this.made) outlines.dispose();
    for (const material of this.added) material.dispose();
    this.forgetSample();
  }

  /** Frees what only `samples` needs. */
  forgetSample(): void {
    this.sample?.material.dispose();
    this.sample?.dispose();
    this.sample = null;
  }

  private leaveOut(mesh: Mesh, why: string): void {
    this.without.push({ mesh, reason: `The ${describeObject(mesh)} is hatched without outlines: ${why}.` });
  }

  private makeSample(): Drawn {
    this.sample = this.kind.outlines(null, this.kind.material(this.parameters, false));
    return this.sample;
  }

  private materialFor(surface: Material, isDeforming: boolean): Look {
    let look = this.looks.get(surface);
    if (!look) {
      const material = alwaysBlended(this.kind.material(this.parameters, isDeforming));
      look = { material, given: new GivenValues(material, EDITABLE) };
      this.looks.set(surface, look);
      this.added.push(material);
    }
    return look.material;
  }
}
