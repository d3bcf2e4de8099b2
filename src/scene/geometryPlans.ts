import type { BufferGeometry, Material, Mesh } from 'three';
import { drawsLines, followsForm, formOf, needsAdjacency } from '../look/queries.js';
import type { HatchingFormOptions } from '../material/geometry/HatchingFormOptions.js';
import type { GeometryPart } from '../material/geometry/jointForms.js';
import type { PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { isBatched, isHatching, materialsOf } from './surfaceMeshes.js';

/** Geometries that may touch, so that lines along their form continue from one to the next. */
export interface FormGroup {
  /** The parts, with matrices to the object space of the first. */
  parts: readonly GeometryPart[];
  /** The form options of the first. */
  form: HatchingFormOptions;
}

/** The options that one geometry is baked with. */
export interface GeometryPlan extends Pick<PrepareHatchingGeometryOptions, 'layout' | 'form'> {
  /** The geometries that share a form with it, if they touch it. */
  group?: FormGroup | undefined;
}

/** The number of corners of a geometry, whatever its draw range. */
export const cornerCount = ({ index, attributes }: BufferGeometry): number =>
  (index ?? attributes.position)?.count ?? 0;

/** A mesh to hatch, with its former geometry and material. */
export interface OldLook {
  mesh: Mesh;
  /** The geometry that is baked. */
  geometry: BufferGeometry;
  /** The geometry of the mesh, if it differs from `geometry` because a map displaces it. */
  flatGeometry?: BufferGeometry;
  oldMaterial: Material | Material[];
}

/** A mesh to hatch, with its new material. */
export interface PlannedMesh extends OldLook {
  material: Material | Material[];
}

/** Whether no material of a mesh needs triangle adjacency. */
export const needsNoAdjacency = (plan: PlannedMesh): boolean =>
  materialsOf(plan).every((material) => isHatching(material) && !needsAdjacency(material));

/**
 * All geometries to bake, each with a layout that works for all materials that draw it, and with a form field if one of them needs it.
 */
export function geometryPlans(
  planned: readonly PlannedMesh[],
  options: PrepareHatchingGeometryOptions,
): Map<BufferGeometry, GeometryPlan> {
  const { layout, adjacency = false } = options;
  const plans = new Map<BufferGeometry, GeometryPlan>();
  for (const plan of planned) {
    if (isBatched(plan.mesh)) continue;
    const before = plans.get(plan.geometry);
    const isIndexed = before?.layout !== 'auto' && !adjacency && needsNoAdjacency(plan);
    plans.set(plan.geometry, {
      layout: layout ?? (isIndexed ? 'indexed' : 'auto'),
      form: before?.form || formFor(plan, options),
    });
  }
  return plans;
}

/** The materials of a mesh that need the form: those that need it for any shape take precedence. */
export function askingMaterials(plan: PlannedMesh): HatchingMaterial[] {
  const following = materialsOf(plan)
    .filter(isHatching)
    .filter((material) => followsForm(material));
  return following.sort((one, other) => Number(formOf(one) === 'auto') - Number(formOf(other) === 'auto'));
}

/** The material that decides the angle at which lines are baked to cross. Strokes cross by being turned and need no bake. */
export const crossingOf = (asking: readonly HatchingMaterial[]): HatchingMaterial | undefined =>
  asking.find((material) => drawsLines(material.technique));

/** The options of the form field: the world's up direction and the angle of the material, unless the options set others. */
function formFor(plan: PlannedMesh, { form }: PrepareHatchingGeometryOptions): GeometryPlan['form'] {
  const asking = askingMaterials(plan);
  if (form === false || (!form && asking.length === 0)) return false;
  // The gradient of the height in the world, as a function in object space.
  const { elements } = plan.mesh.matrixWorld;
  const up = [elements[1], elements[5], elements[9]] as const;
  const auto = form === 'auto' || (!form && formOf(asking[0]) === 'auto');
  const crossing = crossingOf(asking);
  return { up, auto, ...(crossing && { crossAngle: crossing.crossAngle }), ...(typeof form === 'object' && form) };
}

/** The geometry and material of a mesh, and the coordinate frame of its lines. */
export interface MeshLook {
  mesh: Mesh;
  geometry: BufferGeometry;
  material: Material | Material[];
  /** The matrix from the mesh's object space to the coordinate frame of its lines, if it shares that frame with others. */
  fieldFrame: number[] | undefined;
}
