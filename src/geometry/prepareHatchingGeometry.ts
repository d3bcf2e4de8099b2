import type { BufferGeometry } from 'three';
import type { BakeRequest } from '../bake/bake.js';
import type { LineRequest } from '../bake/bakeLines.js';
import type { VertexWords } from '../bake/expandPerCorner.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import { checkNames, checkOptions } from '../worker/checkOptions.js';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { checkGeometry } from './checkGeometry.js';
import { applyCorners } from './cornerGeometry.js';
import { type CornerRange, cornerRange } from './cornerRange.js';
import { extractMesh } from './extractMesh.js';
import type { HatchingStatistics } from './HatchingStatistics.js';
import { applyIndexed } from './indexedGeometry.js';
import { lineDataOf } from './LineData.js';
import { startGeometry } from './preparedGeometry.js';
import { applyPull } from './pulledGeometry.js';
import { countUnusableNormals, type Repairs, zeroBadValues } from './repairValues.js';
import { rememberSource } from './sourceState.js';
import { triangleGroups } from './triangleGroups.js';
import { extractWords, type KeptAttribute, keptAttributes } from './vertexAttributes.js';

/** Options of `prepareHatchingGeometry`. */
export interface PrepareHatchingGeometryOptions extends TaskOptions {
  /**
   * What is stored per vertex.
   *
   * - `'corner'`: every corner carries the positions of all six adjacency vertices, 252 bytes per triangle. For every technique.
   * - `'pull'`: the positions lie in a texture that a pre-pass can deform, and corners read all six from it: 32 bytes per
   *   triangle and 16 per vertex. Draws the same pixels. For every technique, and for meshes that deform.
   * - `'indexed'`: the geometry as it is, with eight more bytes per vertex. Only for `anchored` and `engraved`, which draw without adjacency.
   * - `'auto'` (default): `'pull'` for a geometry with a skin, with morph targets of position or normal or with more than 200,000
   *   triangles, where uploading the corners would block the page for some hundred milliseconds; else `'corner'`.
   */
  layout?: 'auto' | 'corner' | 'pull' | 'indexed' | undefined;
  /**
   * Triangles whose normals differ by this angle or more, in radians from 0 to π, do not blend across their common edge.
   * Default π/2, the rule of Suarez et al., section 3.3. Where normals are computed because the geometry has none, they are
   * split at these edges too.
   */
  creaseAngle?: number | undefined;
  /**
   * The scale of `hatchNormal`, which gives strokes their frame, in object units. Detail finer than this, such as the noise of a
   * scan, does not bend strokes. Sharp edges stay sharp at any scale. Default: 0.03 times the radius of the bounding sphere;
   * 0 leaves the normals unsmoothed.
   */
  smoothingRadius?: number | undefined;
  /**
   * Borders whose vertices lie this near each other, along each axis, count as one, as a share of the radius of the bounding
   * sphere. Default 1e-6, which closes seams that rounding has opened, such as those of three's own sphere and torus; 0 joins
   * only what lies at exactly the same position. What is drawn keeps its positions.
   */
  weldTolerance?: number | undefined;
  /**
   * Bakes what `HatchingLines` draws contours, borders and creases from: 16 bytes per triangle, 32 per vertex and 16 per
   * feature edge, and 24 per vertex on the heap. `true` or limits of the creases that are drawn. Default: nothing.
   */
  lines?: boolean | LineOptions | undefined;
}

/** Which edges are creases. */
export interface LineOptions {
  /**
   * Edges whose triangles' normals differ by this angle or more, in radians from 0 to π, are creases. Default: edges sharper
   * than 50° once the normals are freed of noise.
   */
  creaseAngle?: number | undefined;
  /**
   * Creases that hang together are drawn if they are this long in all, in object units; 0 draws all. Default: 0.2 times the
   * radius of the bounding sphere, without which scans bristle.
   */
  creaseLength?: number | undefined;
}

const LINE_OPTIONS = { creaseAngle: true, creaseLength: true } satisfies Record<keyof LineOptions, true>;

const PREPARE_OPTIONS = {
  layout: true,
  creaseAngle: true,
  smoothingRadius: true,
  weldTolerance: true,
  lines: true,
} satisfies Record<Exclude<keyof PrepareHatchingGeometryOptions, keyof TaskOptions>, true>;

/**
 * Checks the names of the options and what all tasks have in common.
 *
 * @param more the names of further options that the caller has
 * @throws TypeError naming the caller and the option
 */
export const checkPrepareOptions = (
  caller: string,
  options: PrepareHatchingGeometryOptions,
  more: Readonly<Record<string, true>> = {},
): void => checkOptions(caller, options, { ...more, ...PREPARE_OPTIONS });

const DEFAULT_CREASE_ANGLE = Math.PI / 2;

/** Triangles above which `'auto'` avoids the layout `'corner'`. */
const MANY_TRIANGLES = 200_000;

/**
 * Makes the geometry that `HatchingMaterial` draws. Runs in a worker. Every layout has the attribute `hatchNormal`, the
 * normal at the scale of a stroke (four normalised 16-bit integers; the last is 0, and `bakeOcclusion` writes there).
 *
 * - Layout `'corner'`: finds the three neighbours of every triangle and stores, for each corner, the positions of the six
 *   adjacency vertices (Suarez et al., section 3.2, figure 5; see `cornerLayout.ts`). Non-indexed; positions become 32-bit
 *   floats. With normal, uv, colour, instance matrix and instance colour it takes 15 of WebGL's 16 vertex attributes.
 * - Layout `'pull'`: non-indexed too. The indices of the adjacency vertices and their positions lie in two textures that belong
 *   to the geometry and to its clones. They do not survive `toJSON`, and a `BatchedMesh` cannot draw them.
 * - Layout `'indexed'`: the vertices of the source, plus copies of those at sharp edges, which need a normal on either side.
 *   Has an index even if the source had none, 16-bit where that is enough.
 *
 * The result is a new geometry of the triangles in the draw range. All other attributes of the source keep their types; morph
 * targets, groups, name and user data are kept too. Normals that are missing, or zero or not finite at a vertex that a triangle
 * uses, are computed. Other values that three reads and that are not finite become 0. Both are counted. `userData.hatching`
 * holds a `HatchingStatistics`. `geometry` itself is never changed.
 *
 * Vertices at the same position count as one, so seams of uv or normal do not separate triangles; so do vertices at borders
 * within the `weldTolerance`, unless that would join a chain wider than four tolerances or collapse a triangle. Border edges,
 * non-manifold edges without a partner and degenerate triangles contribute nothing to their neighbours, and are counted.
 *
 * Rejects with a TypeError or RangeError that says what to repair, for: something that is not a BufferGeometry; no
 * `position`; no triangles; a count that is not a multiple of three; an index out of range; a position that is not
 * finite; memory that is gone; an attribute shorter than `position`; an option that is unknown or out of its range. Rejects
 * with the signal's reason when aborted, and with an Error when the worker is disposed of meanwhile. When the worker dies, the
 * bake starts once more in a new one, then on the main thread, each with a warning in the console; if `geometry` was changed
 * since, it rejects with an Error instead.
 */
export async function prepareHatchingGeometry(
  geometry: BufferGeometry,
  options: PrepareHatchingGeometryOptions = {},
): Promise<BufferGeometry> {
  checkPrepareOptions('prepareHatchingGeometry', options);
  options.signal?.throwIfAborted();
  const creaseAngle = options.creaseAngle ?? DEFAULT_CREASE_ANGLE;
  checkValues(options, creaseAngle);
  const label = checkGeometry(geometry);
  const range = cornerRange(geometry, label);
  const kept = keptAttributes(geometry);
  const position = geometry.attributes.position;
  const prepared = startGeometry(geometry, range);
  const source = extractSource(geometry, range, kept);
  const { mesh, copied, ...repairs } = source;
  const request = {
    label,
    creaseAngle,
    smoothingRadius: options.smoothingRadius,
    weldTolerance: options.weldTolerance,
    wantsNormals: repairs.computedNormals > 0,
    lines: lineRequest(options.lines, range),
  };
  const layout = chooseLayout(geometry, mesh.indices.length / 3, options);
  const isUnchanged = rememberSource(geometry);
  const extractAgain = () => {
    if (!isUnchanged()) throw new Error(`${label} was changed while it was being prepared.`);
    return extractSource(geometry, range, kept);
  };

  if (layout === 'indexed') {
    const place = { name: 'position', isMorphTarget: false, attribute: position };
    const attributes = [
      { ...place, ...extractWords(position, position.count) },
      ...kept.map((entry, i) => ({ ...entry, ...copied[i] })),
    ];
    const result = await runTask('bakeIndexed', { ...request, mesh }, options, () => ({
      ...request,
      mesh: extractAgain().mesh,
    }));
    applyIndexed(prepared, attributes, { ...result, ...repairs });
    return withWorker(prepared, options);
  }
  const baking = ({ mesh, copied }: ExtractedSource): BakeRequest => ({ ...request, mesh, attributes: copied });
  const bakeAgain = (): BakeRequest => baking(extractAgain());
  if (layout === 'pull') {
    applyPull(prepared, kept, { ...(await runTask('bakePull', baking(source), options, bakeAgain)), ...repairs });
  } else {
    applyCorners(prepared, kept, { ...(await runTask('bake', baking(source), options, bakeAgain)), ...repairs });
  }
  return withWorker(prepared, options);
}

/** What is copied out of a geometry, with its repairs. */
interface ExtractedSource extends Repairs {
  mesh: TriangleMesh;
  /** Of every kept attribute. */
  copied: VertexWords[];
}

function extractSource(geometry: BufferGeometry, range: CornerRange, kept: readonly KeptAttribute[]): ExtractedSource {
  const mesh = extractMesh(geometry, range);
  let zeroedValues = 0;
  const copied = kept.map((entry) => {
    const copy = extractWords(entry.attribute, geometry.attributes.position.count);
    zeroedValues += zeroBadValues(geometry, entry, copy);
    return copy;
  });
  return { mesh, copied, computedNormals: countUnusableNormals(geometry, mesh.indices), zeroedValues };
}

/** Lets lines search for contours in the worker that the options name. */
function withWorker(prepared: BufferGeometry, { createWorker }: TaskOptions): BufferGeometry {
  const lines = lineDataOf(prepared);
  if (lines) lines.createWorker = createWorker;
  return prepared;
}

function lineRequest(lines: PrepareHatchingGeometryOptions['lines'], range: CornerRange): LineRequest | null {
  if (!lines) return null;
  return { ...(lines === true ? {} : lines), triangleGroups: triangleGroups(range) };
}

function chooseLayout(
  { attributes, morphAttributes }: BufferGeometry,
  triangleCount: number,
  { layout = 'auto' }: PrepareHatchingGeometryOptions,
): HatchingStatistics['layout'] {
  if (layout !== 'auto') return layout;
  const deforms = attributes.skinIndex || morphAttributes.position || morphAttributes.normal;
  return deforms || triangleCount > MANY_TRIANGLES ? 'pull' : 'corner';
}

function checkValues(
  { layout = 'auto', smoothingRadius = 0, weldTolerance = 0, lines }: PrepareHatchingGeometryOptions,
  creaseAngle: number,
): void {
  if (!['auto', 'corner', 'pull', 'indexed'].includes(layout)) {
    throw new RangeError(
      `prepareHatchingGeometry: unknown layout '${layout}'. Use 'auto', 'corner', 'pull' or 'indexed'.`,
    );
  }
  checkAngle('creaseAngle', creaseAngle);
  if (lines !== undefined && typeof lines !== 'boolean') checkLines(lines);
  if (!(smoothingRadius >= 0 && smoothingRadius < Infinity)) {
    throw new RangeError(
      `prepareHatchingGeometry: smoothingRadius is ${smoothingRadius}. Pass a length in object units, 0 or more, or leave the option out.`,
    );
  }
  if (!(weldTolerance >= 0 && weldTolerance < Infinity)) {
    throw new RangeError(
      `prepareHatchingGeometry: weldTolerance is ${String(weldTolerance)}. Pass a share of the bounding radius, 0 or more, such as 1e-6, or leave the option out.`,
    );
  }
}

function checkLines(lines: LineOptions): void {
  checkNames('prepareHatchingGeometry', 'lines', lines, LINE_OPTIONS);
  if (lines.creaseAngle !== undefined) checkAngle('lines.creaseAngle', lines.creaseAngle);
  const { creaseLength = 0 } = lines;
  if (creaseLength >= 0 && creaseLength < Infinity) return;
  throw new RangeError(
    `prepareHatchingGeometry: lines.creaseLength is ${creaseLength}. Pass a length in object units, 0 or more, or leave the option out.`,
  );
}

function checkAngle(name: string, angle: number): void {
  if (angle >= 0 && angle <= Math.PI) return;
  throw new RangeError(
    `prepareHatchingGeometry: ${name} is ${angle}. Pass an angle in radians from 0 to π; 60 degrees is Math.PI / 3.`,
  );
}
