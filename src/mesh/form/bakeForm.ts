import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { TENSOR_FLOATS } from '../features/fanCurvatures.js';
import { asPhase, forEachChunk, release } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { cutForm, type FormSeam } from './cutForm.js';
import { directionField } from './directions/directionField.js';
import { type FaceDirections, faceDirections } from './directions/faceDirections.js';
import type { FormField, FormOptions } from './FormField.js';
import { type FormSurface, formSurface } from './FormSurface.js';
import { formVertices } from './formVertices.js';
import { phaseLevels } from './phase/phaseLevels.js';
import { phaseMatrix } from './phase/phaseMatrix.js';
import { phaseSource } from './phase/phaseSource.js';
import { type SeamRelations, seamRelations } from './phase/seamRelations.js';
import { type Phase, solvePhase } from './phase/solvePhase.js';

/** Lines per bounding radius at the nominal slope of φ. Denser lines come from octaves of φ, in powers of two. */
export const LINES_PER_RADIUS = 16;

/**
 * Bakes the field of lines that follow the form. It depends on the shape alone, not on scale, position or chance. φ does not depend on
 * `crossAngle`, to the last bit.
 *
 * @param twins with NO_TWIN where windings contradict each other (`consistentTwins`); freed
 * @param radius the bounding radius of the mesh
 */
export function* bakeForm(
  mesh: TriangleMesh,
  adjacency: Pick<TriangleAdjacency, 'canonicalCorners' | 'areaNormals'>,
  twins: Int32Array<ArrayBuffer>,
  radius: number,
  options: FormOptions,
): Generator<number, FormField, void> {
  const surface = yield* asPhase(formSurface(mesh, adjacency, twins, radius, options), 0, 0.3);
  release(twins);
  return yield* asPhase(fieldOn(surface, options), 0.3, 1);
}

/** Like `bakeForm`, but returns null for a shape of flat faces, which has no form (`chooseDirection`). */
export function* bakeChosenForm(
  mesh: TriangleMesh,
  adjacency: Pick<TriangleAdjacency, 'canonicalCorners' | 'areaNormals'>,
  twins: Int32Array<ArrayBuffer>,
  radius: number,
  options: FormOptions,
): Generator<number, FormField | null, void> {
  const surface = yield* asPhase(formSurface(mesh, adjacency, twins, radius, options), 0, 0.3);
  release(twins);
  const { direction } = yield* asPhase(chooseDirection(surface), 0.3, 0.31);
  return direction === 'form' ? yield* asPhase(fieldOn(surface, options), 0.31, 1) : null;
}

/** The field on a prepared surface, whose arrays are freed one by one as soon as they are no longer needed. */
function* fieldOn(surface: FormSurface, options: FormOptions): Generator<number, FormField, void> {
  const directions = yield* asPhase(formDirections(surface, options), 0, 0.5);
  const { heat, normals, partShares } = surface;
  release(normals, partShares, heat.masses, heat.degrees);
  const seam = yield* asPhase(cutForm(surface, directions), 0.5, 0.6);
  release(seam.cutTwins);
  return yield* asPhase(combedField(surface, directions, seam, options.crossAngle), 0.6, 1);
}

/** The directions of the faces. The field that they come from is freed on return. */
function* formDirections(surface: FormSurface, options: FormOptions): Generator<number, FaceDirections, void> {
  const field = yield* asPhase(directionField(surface, options), 0, 0.92);
  return yield* asPhase(faceDirections(surface, field), 0.92, 1);
}

/** Finds φ and φ₂ on a surface that is cut so that directions can be combed. The directions are freed. */
export function* combedField(
  surface: FormSurface,
  directions: FaceDirections,
  seam: FormSeam,
  crossAngle: number,
): Generator<number, FormField, void> {
  const { relations, phase } = yield* asPhase(combedPhase(surface, directions, seam, crossAngle), 0, 0.85);
  return yield* asPhase(formVertices(surface, seam, relations, phase), 0.85, 1);
}

/** Solves for φ and φ₂. Temporary data is freed before the vertices are made. */
function* combedPhase(
  surface: FormSurface,
  directions: FaceDirections,
  seam: FormSeam,
  crossAngle: number,
): Generator<number, { relations: SeamRelations; phase: Phase }, void> {
  const relations = yield* asPhase(seamRelations(surface, seam), 0, 0.05);
  const { matrix, shares } = yield* asPhase(phaseMatrix(surface, seam, relations), 0.05, 0.15);
  release(surface.heat.neighbours);
  const levels = yield* asPhase(phaseLevels(matrix), 0.15, 0.25);
  // A mesh without extent has no lines.
  const slope = surface.radius > 0 ? LINES_PER_RADIUS / surface.radius : 0;
  const families = { slope, crossAngle };
  const source = yield* asPhase(phaseSource(surface, directions, seam, relations, shares, families), 0.25, 0.3);
  release(directions.across, directions.normals, shares);
  return { relations, phase: yield* asPhase(solvePhase(surface, seam, relations, levels, source), 0.3, 1) };
}

/** The field chosen for `direction: 'auto'`, and the measure behind it. */
interface DirectionChoice {
  direction: 'form' | 'light';
  /** The share of the surface that is flat, from 0 to 1. */
  flatShare: number;
}

/** Fans of a smaller curvature, times the bounding radius, are flat: they give lines no direction. */
const FLAT_CURVATURE = 0.3;

/**
 * From this share on, a mesh consists of flat faces. Shares are clearly high or low: of the models of the playground, a column with its
 * lids has 0.17, the highest with a form, and gears 0.69, the lowest without.
 */
const FLAT_FACED_SHARE = 0.4;

/**
 * Chooses between lines that follow the form, for organic shapes, and lines that follow the light, for machine parts and other meshes of
 * flat faces, which have no form. The measure is the share of the area that is flat between the creases.
 */
export function* chooseDirection({
  masses,
  tensors,
  radius,
}: Pick<FormSurface, 'masses' | 'tensors' | 'radius'>): Generator<number, DirectionChoice, void> {
  const limit = (FLAT_CURVATURE / radius) ** 2;
  let area = 0;
  let flat = 0;
  yield* forEachChunk(masses.length, (start, end) => {
    for (let fan = start; fan < end; fan++) area += masses[fan];
    flat += flatArea(masses, tensors, limit, start, end);
  });
  const flatShare = area > 0 ? flat / area : 1;
  return { direction: flatShare < FLAT_FACED_SHARE ? 'form' : 'light', flatShare };
}

/** The area of those of a range of fans whose curvature has a square below `limit`. */
function flatArea(masses: Float64Array, tensors: Float32Array, limit: number, start: number, end: number): number {
  let area = 0;
  for (let fan = start; fan < end; fan++) {
    const i = TENSOR_FLOATS * fan;
    const diagonal = tensors[i] ** 2 + tensors[i + 3] ** 2 + tensors[i + 5] ** 2;
    const beside = tensors[i + 1] ** 2 + tensors[i + 2] ** 2 + tensors[i + 4] ** 2;
    if (diagonal + 2 * beside < limit) area += masses[fan];
  }
  return area;
}
