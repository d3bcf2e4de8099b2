import type { HatchingTechnique } from '../../look/hatchingProperties.js';
import { checkOptions, type TaskOptions } from '../../worker/TaskOptions.js';
import type { HatchingFormOptions } from './HatchingFormOptions.js';

/** Options of `prepareHatchingGeometry`. */
export interface PrepareHatchingGeometryOptions extends TaskOptions {
  /**
   * Whether to bake the neighbours of every triangle, which the techniques `triangle` and `adjacency` need; such a geometry can be
   * drawn by every technique. Default: false, for all other techniques, which draw the source's own vertices.
   */
  adjacency?: boolean | undefined;
  /** The technique that will draw the geometry, from which the need for adjacency follows. Default: `adjacency` decides. */
  technique?: HatchingTechnique | undefined;
  /**
   * The vertex layout: how the adjacency is stored. It rarely needs to be set. Default: `'auto'` with `adjacency`, `'indexed'` without.
   *
   * - `'corner'`: every corner carries the positions of all six adjacency vertices, 252 bytes per triangle. It works with every
   * technique.
   * - `'pull'`: the positions lie in a texture that a pre-pass can deform, and every corner reads all six from it: 32 bytes per
   * triangle and 16 per vertex. It works with every technique and with meshes that deform, and draws the same pixels as
   * `'corner'`.
   * - `'indexed'`: the source geometry, with eight more bytes per vertex. It works with all techniques but `triangle` and `adjacency`,
   * which need adjacency.
   * - `'auto'`: `'pull'` for a geometry with a skin, with morph targets of position or normal, or with more than
   * 200,000 triangles, where the upload of all corners would block the page for some hundred milliseconds; otherwise
   * `'corner'`.
   */
  layout?: 'auto' | 'corner' | 'pull' | 'indexed' | undefined;
  /**
   * Triangles whose normals differ by this angle or more, in radians from 0 to π, do not blend across their common edge. If
   * normals are computed because the geometry has none, they are split at these edges too. Default π/2, the rule of Suarez et
   * al., section 3.3.
   */
  creaseAngle?: number | undefined;
  /**
   * The scale at which `hatchNormal`, the normal that orients strokes, is smoothed, in object units, 0 or more. Detail finer than
   * this, such as the noise of a scan, does not bend strokes. Sharp edges stay sharp at any scale. 0 leaves the normals as they
   * are. Default: 0.03 times the radius of the bounding sphere.
   */
  smoothingRadius?: number | undefined;
  /**
   * Borders whose vertices lie this near to each other along each axis are joined, as a share of the radius of the bounding sphere, 0
   * or more. 0 joins only vertices at exactly the same position. The positions that are drawn do not change. Default 1e-6, which closes
   * seams that are open by rounding errors, such as those of three's own sphere and torus.
   */
  weldTolerance?: number | undefined;
  /**
   * Bakes the data that `HatchingOutlines` draws contours, borders and creases from: on the GPU 16 bytes per triangle, 32 per vertex
   * and 16 per feature edge, and 24 bytes per vertex on the heap. Pass `true`, or options that decide which edges are creases.
   * Default: no outlines.
   */
  outlines?: boolean | OutlineOptions | undefined;
  /**
   * Bakes the form field: the functions whose level sets are lines with the direction `'form'` or `'acrossForm'`, and
   * that strokes are laid along, in 24 bytes per vertex; a few vertices are copied. It takes several times as long as all the
   * rest, in the worker. Pass `true`, `'auto'` for shapes that have a form only (and not for meshes of flat faces), or options.
   * Default: false; `applyHatching` bakes them if a material needs them.
   */
  form?: boolean | 'auto' | HatchingFormOptions | undefined;
  /**
   * Whether to turn triangles that face the wrong way, as in files that were made without regard to it: patches whose windings contradict
   * each other, closed surfaces that face inward, and open ones that are seen from their back. Walls of cavities, rooms around other parts,
   * and surfaces that are seen as much from one side as from the other are left as they are. Normals that then point to the back are
   * reversed; a vertex that is shared by a turned and another triangle is copied. Default: false, which trusts the winding.
   */
  orient?: boolean | undefined;
}

/** Decides which edges are drawn as creases. */
export interface OutlineOptions {
  /**
   * Edges are creases if the normals of their triangles differ by this angle or more, in radians from 0 to π. Default: edges
   * with an angle of more than 50° after the normals were filtered against noise.
   */
  featureAngle?: number | undefined;
  /**
   * Connected creases are drawn if they are at least this long in total, in object units; 0 draws all. Default: 0.2 times the
   * radius of the bounding sphere, because scans have many short creases.
   */
  creaseLength?: number | undefined;
}

/** The names of the properties of `OutlineOptions`. */
export const OUTLINE_OPTIONS = { featureAngle: true, creaseLength: true } satisfies Record<keyof OutlineOptions, true>;

const PREPARE_OPTIONS = {
  adjacency: true,
  layout: true,
  creaseAngle: true,
  smoothingRadius: true,
  weldTolerance: true,
  outlines: true,
  form: true,
} satisfies Record<Exclude<keyof PrepareHatchingGeometryOptions, keyof TaskOptions | 'orient' | 'technique'>, true>;

/**
 * Checks the names of the options, and the values of those that all tasks share.
 *
 * @param more the names of further options of the caller
 * @throws TypeError that names the caller and the option
 */
export const checkPrepareOptions = (
  caller: string,
  options: PrepareHatchingGeometryOptions,
  more: Readonly<Record<string, true>> = {},
): void => checkOptions(caller, options, { ...more, ...PREPARE_OPTIONS });

/** The default of the option `creaseAngle`. */
export const DEFAULT_CREASE_ANGLE = Math.PI / 2;

/** The number of triangles above which `'auto'` chooses the layout `'pull'`. */
export const MANY_TRIANGLES = 200_000;
