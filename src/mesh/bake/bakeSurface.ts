import {
  buildTriangleAdjacency,
  consistentTwins,
  type TriangleAdjacency,
} from '../adjacency/buildTriangleAdjacency.js';
import type { Nearness } from '../adjacency/joinBorders.js';
import type { EdgeCounts } from '../adjacency/pairEdges.js';
import { isCoarse } from '../features/isCoarse.js';
import { bakeChosenForm, bakeForm } from '../form/bakeForm.js';
import type { FormField, FormOptions } from '../form/FormField.js';
import { type Bounds, measureBounds } from '../measureBounds.js';
import type { FanSurface } from '../normals/assembleHeatEquation.js';
import { cutCreases, cutSharpEdges } from '../normals/cutCreases.js';
import { computeSmoothNormals, type FanNormals, fanDirections } from '../normals/fanNormals.js';
import { buildFans } from '../normals/fans.js';
import { absorbSmallPatches, findPatches, type Patches } from '../normals/findPatches.js';
import { smoothFanNormals } from '../normals/smoothFanNormals.js';
import { asPhase, release } from '../phases.js';
import { type TriangleMesh, validateTriangleMesh } from '../TriangleMesh.js';
import { bakeOutlines, type OutlineRequest, type OutlineSurface, outlineSmoothingRadii } from './bakeOutlines.js';
import { type PackedOutlines, packOutlines } from './packOutlines.js';

/** The input of the bake for every layout. Plain data: it is posted to the worker. */
export interface SurfaceRequest {
  /** Start of every error message: the function that was called and the geometry that was passed. */
  label: string;
  mesh: TriangleMesh;
  /** Triangles whose normals differ by this angle or more, in radians, are not neighbours. */
  creaseAngle: number;
  /** Borders this near to each other are joined, as a share of the bounding radius. See `nearnessOf`. */
  weldTolerance?: number | undefined;
  /** Detail finer than this, in object units, does not turn the hatch normals. See `DEFAULT_SMOOTHING_SHARE`. */
  smoothingRadius?: number | undefined;
  /** Whether to compute smooth normals, for a mesh that has no normals. */
  wantsNormals: boolean;
  /** The outlines to bake, if any. */
  outlines?: OutlineRequest | null | undefined;
  /** Options of the form field, if requested. */
  form?: FormRequest | null | undefined;
  /** The form field, if it was baked before together with other meshes. */
  bakedForm?: FormField | null | undefined;
}

/** Options of the bake of a form field. Plain data: it is posted to the worker. */
export interface FormRequest extends FormOptions {
  /** Whether the field is baked only for shapes that have a form (`chooseDirection`). */
  isChosen: boolean;
}

/** The result of the part of the bake that all layouts share. */
export interface Surface {
  /** The adjacency after the creases were cut. Its twins are free where the layout does not need them. */
  adjacency: TriangleAdjacency;
  bounds: Bounds;
  hatchNormals: FanNormals;
  /** The smooth normals, if requested. Small patches aside, each of their fans is a union of fans of the hatch normals. */
  smoothNormals: FanNormals | null;
  /** The surface that outlines are drawn from, if requested. */
  outlines: OutlineSurface | null;
  /** The form field, if requested, and if the shape has a form where that was a condition. */
  form: FormField | null;
}

/**
 * The default smoothing radius, as a share of the radius of the bounding sphere. A stroke is about a tenth of that radius
 * long. The noise of a scan is far finer; the folds of a robe or the scales of a dragon are as large or larger.
 */
export const DEFAULT_SMOOTHING_SHARE = 0.03;

/** The default weld tolerance, as a share of the bounding radius: a few rounding errors of single precision. */
const DEFAULT_WELD_TOLERANCE = 1e-6;

/** Smaller weld tolerances count as 0: they are far below the resolution of single precision. */
const MIN_WELD_TOLERANCE = 2 ** -40;

/** The relative rounding error of single precision. */
const SINGLE_ROUNDING = 2 ** -23;

/** How near to each other the borders of a mesh must lie to be joined, in object units. */
export function nearnessOf({ radius }: Bounds, share = DEFAULT_WELD_TOLERANCE): Nearness {
  const used = share < MIN_WELD_TOLERANCE ? 0 : share;
  return { tolerance: used * radius, rounding: Math.min(used, SINGLE_ROUNDING) * radius };
}

/** The share of the progress for the form field, if there is one. */
const FORM_SHARE = 0.75;

/**
 * Validates the mesh, finds its adjacency, cuts the creases and computes the hatch normals, the smooth ones, the outlines and the form field.
 *
 * @param keepsTwins whether the layout needs the twins. Else they are cut at sharp edges too: a copy would take memory
 */
export function* bakeSurface(request: SurfaceRequest, keepsTwins: boolean): Generator<number, Surface, void> {
  const { mesh, bakedForm = null } = request;
  const formToBake = bakedForm ? null : request.form;
  const total = formToBake ? 1 - FORM_SHARE : 1;
  const share = (request.outlines ? 0.75 : 1) * total;
  yield* asPhase(validateTriangleMesh(mesh, request.label), 0, 0.03 * share);
  const bounds = yield* asPhase(measureBounds(mesh), 0.03 * share, 0.06 * share);
  const nearness = nearnessOf(bounds, request.weldTolerance);
  const adjacency = yield* asPhase(buildTriangleAdjacency(mesh, nearness), 0.06 * share, 0.3 * share);
  const joinedTwins = request.outlines ? adjacency.twins.slice() : null;
  yield* asPhase(cutCreases(adjacency, request.creaseAngle), 0.3 * share, 0.33 * share);
  const cutTwins = keepsTwins ? adjacency.twins.slice() : adjacency.twins;
  const twins = yield* asPhase(consistentTwins(adjacency, cutTwins), 0.33 * share, 0.34 * share);
  const formTwins = formToBake ? twins.slice() : null;
  const smoothNormals = request.wantsNormals
    ? yield* asPhase(bakeSmoothNormals(twins, adjacency.areaNormals), 0.34 * share, 0.4 * share)
    : null;
  const surface = yield* asPhase(separateFans(mesh, adjacency, twins), 0.4 * share, 0.5 * share);
  // The contours of a coarse mesh run along its edges, so it needs no smoothed normals for them.
  const hasSmoothOutlines =
    joinedTwins !== null &&
    !(yield* asPhase(isCoarse(mesh, surface.twins, adjacency.areaNormals, bounds.radius), 0.5 * share, 0.52 * share));
  const radius = request.smoothingRadius ?? DEFAULT_SMOOTHING_SHARE * bounds.radius;
  const lineRadii = hasSmoothOutlines ? outlineSmoothingRadii(bounds.radius) : [];
  const smoothed = yield* asPhase(smoothFanNormals(surface, [radius, ...lineRadii]), 0.52 * share, 0.93 * share);
  const patches = yield* asPhase(findPatches(surface), 0.93 * share, 0.95 * share);
  const hatchNormals = yield* asPhase(directHatchNormals(surface, patches, radius, smoothed[0]), 0.95 * share, share);
  const outlines =
    joinedTwins &&
    (yield* asPhase(
      bakeOutlines(
        surface,
        patches,
        joinedTwins,
        hasSmoothOutlines ? smoothed.slice(1) : null,
        bounds.radius,
        request.outlines!,
      ),
      share,
      total,
    ));
  // Frees what the form field does not need. With `keepsTwins` these twins are a copy of the layout's.
  release(...smoothed, patches.ofTriangle, twins);
  if (joinedTwins) release(joinedTwins);
  const bakeField = formToBake?.isChosen ? bakeChosenForm : bakeForm;
  const form = formTwins
    ? yield* asPhase(bakeField(mesh, adjacency, formTwins, bounds.radius, formToBake!), total, 1)
    : bakedForm;
  return { adjacency, bounds, hatchNormals, smoothNormals, outlines, form };
}

function* bakeSmoothNormals(twins: Int32Array, areaNormals: Float64Array): Generator<number, FanNormals, void> {
  const fans = yield* asPhase(buildFans(twins), 0, 0.5);
  return { fans, normals: yield* asPhase(computeSmoothNormals(areaNormals, fans), 0.5, 1) };
}

/** Cuts the surface at sharp edges and finds the remaining fans. `twins` is changed in place. */
function* separateFans(
  mesh: TriangleMesh,
  { canonicalCorners, areaNormals }: TriangleAdjacency,
  twins: Int32Array<ArrayBuffer>,
): Generator<number, FanSurface, void> {
  yield* asPhase(cutSharpEdges(twins, areaNormals), 0, 0.7);
  const fans = yield* asPhase(buildFans(twins), 0.7, 1);
  return { mesh, twins, canonicalCorners, areaNormals, fans };
}

/**
 * Computes unit normals from normals that were smoothed with `radius`. A patch smaller than a disc of that diameter takes the
 * normals of the surface around it and does not influence them: its corners are moved to the fans around it, in place.
 */
function* directHatchNormals(
  surface: FanSurface,
  patches: Patches,
  radius: number,
  smoothed: Float32Array,
): Generator<number, FanNormals, void> {
  const { areaNormals, fans } = surface;
  const smallest = Math.PI * (radius / 2) ** 2;
  // Negated, so that NaN counts as small.
  yield* asPhase(
    absorbSmallPatches(surface, patches, fans, (area) => !(area >= smallest)),
    0,
    0.6,
  );
  return { fans, normals: yield* asPhase(fanDirections(smoothed, areaNormals, fans), 0.6, 1) };
}

/** The report of a bake on the mesh, the same for all layouts. */
export interface BakeReport extends EdgeCounts {
  bounds: Bounds;
  /** The packed outlines, if requested. */
  outlines: PackedOutlines | null;
}

/**
 * Packs the outlines and collects what the bake reports about the mesh.
 *
 * @param indices the vertex of each corner in the layout that is baked
 */
export function* reportOf(
  { adjacency, bounds, outlines }: Surface,
  indices: Uint32Array,
): Generator<number, BakeReport, void> {
  const packed = outlines && (yield* packOutlines(outlines, indices));
  yield 1;
  const { borderEdges, nonManifoldEdges, unpairedEdges, inconsistentEdges, degenerateTriangles } = adjacency;
  return {
    bounds,
    borderEdges,
    nonManifoldEdges,
    unpairedEdges,
    inconsistentEdges,
    degenerateTriangles,
    outlines: packed,
  };
}
