import { BufferGeometry, InstancedBufferGeometry } from 'three';
import { HATCHING_TECHNIQUES } from '../../look/hatchingProperties.js';
import { needsAdjacency } from '../../look/queries.js';
import type { BakeRequest } from '../../mesh/bake/bakeCorners.js';
import type { OutlineRequest } from '../../mesh/bake/bakeOutlines.js';
import type { BakeReport } from '../../mesh/bake/bakeSurface.js';
import { appendVertices, type VertexWords } from '../../mesh/bake/vertexWords.js';
import type { FormField } from '../../mesh/form/FormField.js';
import type { TriangleMesh } from '../../mesh/TriangleMesh.js';
import { runTask } from '../../worker/runTask.js';
import { checkNames } from '../../worker/TaskOptions.js';
import { fetchDeformations } from '../deformation/laterDeformations.js';
import { mustBeAwaited } from '../diagnostics/warn.js';
import { applyCorners, applyIndexed, applyPull, attributeFromWords } from './bakedGeometry.js';
import { checkGeometry } from './checkGeometry.js';
import { type CornerRange, cornerRange, extractMesh } from './extractMesh.js';
import { formRequest } from './HatchingFormOptions.js';
import {
  checkPrepareOptions,
  DEFAULT_CREASE_ANGLE,
  MANY_TRIANGLES,
  OUTLINE_OPTIONS,
  type OutlineOptions,
  type PrepareHatchingGeometryOptions,
} from './PrepareHatchingGeometryOptions.js';
import type { HatchingStatistics, NotBaked } from './preparedGeometry.js';
import { countUnusableNormals, type Repairs, zeroBadValues } from './repairValues.js';
import {
  extractWords,
  isInstanced,
  type KeptAttribute,
  keptAttributes,
  type VertexAttribute,
} from './vertexAttributes.js';

/** Captures the data of a geometry. Returns a function that tells whether the data is still the same. */
function rememberSource(geometry: BufferGeometry): () => boolean {
  const before = stateOf(geometry);
  return () => {
    const now = stateOf(geometry);
    return now.length === before.length && now.every((entry, i) => entry === before[i]);
  };
}

/** All arrays that a bake reads, each followed by its version. */
const stateOf = (geometry: BufferGeometry): unknown[] =>
  [geometry.attributes.position, geometry.index, ...keptAttributes(geometry).map(({ attribute }) => attribute)].flatMap(
    (attribute) => (attribute ? [attribute.array, versionOf(attribute)] : [null]),
  );

const versionOf = (attribute: VertexAttribute): number =>
  'data' in attribute ? attribute.data.version : attribute.version;

/** Properties of the geometry that three.js and users read first. */
const FIRST_READ = ['morphAttributes', 'boundingSphere', 'attributes', 'userData'] as const;

/**
 * Prepares a geometry for `HatchingMaterial`, in a worker. In every layout the new geometry has the attribute `hatchNormal`: the
 * normal at the scale of a stroke, as four normalised 16-bit integers. The last of them is 0 until `bakeOcclusion` writes to it.
 *
 * - Layout `'corner'` stores, for each corner, the positions of the six adjacency vertices of its triangle (Suarez et al.,
 *   section 3.2, figure 5; see `attributeLayouts.ts`). The geometry has no index; positions become 32-bit floats. With normal, uv,
 *   colour, instance matrix and instance colour it takes 15 of WebGL's 16 vertex attributes.
 * - Layout `'pull'` has no index either. The indices and positions of the adjacency vertices lie in two textures that belong to
 *   the geometry and its clones. They do not survive `toJSON`, and a `BatchedMesh` cannot draw them.
 * - Layout `'indexed'` keeps the vertices of the source, and adds copies of those at sharp edges, which need a normal for each
 *   side. The geometry has an index even if the source had none; the index has 16 bits if that is enough.
 *
 * The result is a new geometry with the triangles in the draw range; `geometry` itself is never changed. The other attributes of
 * the source keep their types; morph targets, groups, name and user data are kept too. Normals are computed where they are
 * missing, and where they are zero or not finite at a vertex that a triangle uses. Other values that three.js reads become 0 if
 * they are not finite. `userData.hatching` holds a `HatchingStatistics`, which counts both.
 *
 * Vertices at the same position count as one, so that seams of uvs or normals do not separate triangles. Vertices at borders
 * count as one if they lie within the `weldTolerance`, unless that would join a chain wider than four tolerances or collapse a
 * triangle. Border edges, non-manifold edges without a partner and degenerate triangles contribute nothing to their neighbours;
 * they are counted.
 *
 * The promise is rejected
 *
 * - with a TypeError or RangeError that names the remedy, if `geometry` is not a BufferGeometry, has no `position`, no triangles, a
 *   count that is not a multiple of three, an index out of range, a position that is not finite, memory that was freed or an
 *   attribute shorter than `position`; or if an option is unknown or out of its range;
 * - with the signal's reason, when aborted;
 * - with an Error, when the worker is disposed of before the bake is finished.
 *
 * If the worker dies, the bake starts over in a new worker, and if that dies too, on the main thread, each time with a warning in
 * the console. If `geometry` has changed since the call, the promise is rejected with an Error instead.
 */
export function prepareHatchingGeometry(
  geometry: BufferGeometry,
  options: PrepareHatchingGeometryOptions = {},
): Promise<BufferGeometry> {
  return mustBeAwaited(prepareWithForm(geometry, options, null), 'prepareHatchingGeometry()', FIRST_READ);
}

/**
 * `prepareHatchingGeometry` without the warning to callers that do not await it.
 *
 * @param bakedForm a form field of this geometry that was baked before, used instead of baking one for it alone
 */
export async function prepareWithForm(
  geometry: BufferGeometry,
  options: PrepareHatchingGeometryOptions,
  bakedForm: FormField | null,
): Promise<BufferGeometry> {
  checkPrepareOptions('prepareHatchingGeometry', options, { orient: true, technique: true });
  options.signal?.throwIfAborted();
  const creaseAngle = options.creaseAngle ?? DEFAULT_CREASE_ANGLE;
  checkValues(options, creaseAngle);
  const label = checkGeometry(geometry);
  const range = cornerRange(geometry, label);
  const kept = keptAttributes(geometry);
  const position = geometry.attributes.position;
  const prepared = startGeometry(geometry, range);
  const extracted = extractSource(geometry, range, kept);
  const layout = chooseLayout(geometry, extracted.mesh.indices.length / 3, options);
  const isUnchanged = rememberSource(geometry);
  const extractUnturned = () => {
    if (!isUnchanged()) throw new Error(`${label} was changed while it was being prepared.`);
    return extractSource(geometry, range, kept);
  };

  const place = { name: 'position', isMorphTarget: false, attribute: position };
  const unturnedPositions = layout === 'indexed' ? extractWords(position, position.count) : null;
  // Outlines that cannot be drawn for want of it try again.
  const codeOfOutlines = options.outlines && mayDeform(geometry) ? fetchDeformations().catch(() => {}) : undefined;
  // From here on the geometry may change.
  const turn = options.orient ? await turning(label, extracted, kept, options, extractUnturned) : leaveSource;
  const source = turn(extracted);
  const extractAgain = () => turn(extractUnturned());
  const { mesh, copied, copies, ...repairs } = source;
  const own: NotBaked = { ...repairs, createWorker: options.createWorker };
  const positions = unturnedPositions && {
    ...unturnedPositions,
    words: copies ? appendVertices(unturnedPositions, copies) : unturnedPositions.words,
  };
  const request = {
    label,
    creaseAngle,
    smoothingRadius: options.smoothingRadius,
    weldTolerance: options.weldTolerance,
    wantsNormals: repairs.computedNormals > 0,
    outlines: outlineRequest(options.outlines, range),
    form: formRequest('prepareHatchingGeometry', options.form),
    // A form field that was baked for other triangles does not fit.
    bakedForm: bakedForm?.ofCorner.length === mesh.indices.length ? bakedForm : null,
  };

  const requestFor = ({ mesh, copied }: ExtractedSource): BakeRequest => ({ ...request, mesh, attributes: copied });
  const requestAgain = (): BakeRequest => requestFor(extractAgain());
  const complete = async <Baked extends BakeReport>(baking: Promise<Baked>): Promise<Baked & NotBaked> => {
    const baked = await baking;
    if (baked.outlines?.mayCrowd) {
      const code = await import('./spaceOutlines.js');
      await code.spaceOutlines(baked.outlines, options);
    }
    return { ...baked, ...own };
  };
  if (positions) {
    const attributes = [{ ...place, ...positions }, ...kept.map((entry, i) => ({ ...entry, ...copied[i] }))];
    const again = () => ({ ...request, mesh: extractAgain().mesh });
    applyIndexed(prepared, attributes, await complete(runTask('bakeIndexed', { ...request, mesh }, options, again)));
  } else if (layout === 'pull') {
    const baking = runTask('bakePull', requestFor(source), options, requestAgain);
    applyPull(prepared, kept, await complete(baking));
  } else {
    const baking = runTask('bakeCorners', requestFor(source), options, requestAgain);
    applyCorners(prepared, kept, await complete(baking));
  }
  await codeOfOutlines;
  return prepared;
}

/** Whether the meshes of a geometry may have a skin or morph targets. */
const mayDeform = ({ attributes, morphAttributes }: BufferGeometry): boolean =>
  Boolean(attributes.skinIndex || morphAttributes.position || morphAttributes.normal);

/** Copies of a geometry's data that the bake needs, repaired where necessary. */
interface ExtractedSource extends Repairs {
  mesh: TriangleMesh;
  /** The values of every kept attribute. */
  copied: VertexWords[];
  /** The vertices whose copies follow the others. Undefined for none. */
  copies?: Uint32Array<ArrayBuffer>;
}

type Turn = (source: ExtractedSource) => ExtractedSource;

const leaveSource: Turn = (source) => source;

/** Finds the triangles of a source that face the wrong way, in the worker. Resolves with a function that turns them. */
async function turning(
  label: string,
  { mesh: { positions, indices } }: ExtractedSource,
  kept: readonly KeptAttribute[],
  { signal, createWorker }: PrepareHatchingGeometryOptions,
  extractAgain: () => ExtractedSource,
): Promise<Turn> {
  const request = { label, mesh: { positions: positions.slice(), indices: indices.slice() } };
  const again = () => ({ label, mesh: extractAgain().mesh });
  const finding = runTask('orientChecked', request, { signal, createWorker }, again);
  const [{ turnSource }, isTurned] = await Promise.all([import('./turnSource.js'), finding]);
  const turnedTriangles = isTurned.reduce((sum, one) => sum + one, 0);
  return turnedTriangles === 0
    ? leaveSource
    : (source) => ({ ...turnSource(source, kept, isTurned, attributeFromWords), turnedTriangles });
}

function extractSource(geometry: BufferGeometry, range: CornerRange, kept: readonly KeptAttribute[]): ExtractedSource {
  const mesh = extractMesh(geometry, range);
  let zeroedValues = 0;
  const copied = kept.map((entry) => {
    const copy = extractWords(entry.attribute, geometry.attributes.position.count);
    zeroedValues += zeroBadValues(geometry, entry, copy);
    return copy;
  });
  const computedNormals = countUnusableNormals(geometry, mesh.indices);
  return { mesh, copied, computedNormals, zeroedValues, turnedTriangles: 0 };
}

function outlineRequest(
  outlines: PrepareHatchingGeometryOptions['outlines'],
  range: CornerRange,
): OutlineRequest | null {
  if (!outlines) return null;
  return { ...(outlines === true ? {} : outlines), triangleGroups: triangleGroups(range) };
}

function chooseLayout(
  geometry: BufferGeometry,
  triangleCount: number,
  options: PrepareHatchingGeometryOptions,
): HatchingStatistics['layout'] {
  const { layout = wantsAdjacency(options) ? 'auto' : 'indexed' } = options;
  if (layout !== 'auto') return layout;
  return mayDeform(geometry) || triangleCount > MANY_TRIANGLES ? 'pull' : 'corner';
}

const wantsAdjacency = ({ adjacency = false, technique }: PrepareHatchingGeometryOptions): boolean =>
  adjacency || (technique !== undefined && needsAdjacency({ technique }));

function checkValues(options: PrepareHatchingGeometryOptions, creaseAngle: number): void {
  const { adjacency = false, orient = false, technique, layout = 'auto', outlines } = options;
  const { smoothingRadius, weldTolerance } = options;
  for (const [name, value] of Object.entries({ adjacency, orient })) {
    if (typeof value === 'boolean') continue;
    throw new TypeError(
      `prepareHatchingGeometry: ${name} is ${String(value)}. Pass true or false, or leave the option out.`,
    );
  }
  if (technique !== undefined && !Object.hasOwn(HATCHING_TECHNIQUES, technique)) {
    throw new RangeError(
      `prepareHatchingGeometry: unknown technique '${technique}'. Use one of ${Object.keys(HATCHING_TECHNIQUES).join(', ')}.`,
    );
  }
  if (wantsAdjacency(options) && layout === 'indexed') {
    throw new RangeError(
      "prepareHatchingGeometry: the layout 'indexed' has no adjacency. Leave out one of the two options.",
    );
  }
  if (!['auto', 'corner', 'pull', 'indexed'].includes(layout)) {
    throw new RangeError(
      `prepareHatchingGeometry: unknown layout '${layout}'. Use 'auto', 'corner', 'pull' or 'indexed'.`,
    );
  }
  checkAngle('creaseAngle', creaseAngle);
  if (outlines !== undefined && typeof outlines !== 'boolean') checkLines(outlines);
  checkSize('smoothingRadius', smoothingRadius);
  checkSize('weldTolerance', weldTolerance, 'a share of the bounding radius, 0 or more, such as 1e-6');
}

function checkLines(outlines: OutlineOptions): void {
  checkNames('prepareHatchingGeometry', 'outlines', outlines, OUTLINE_OPTIONS);
  checkAngle('outlines.featureAngle', outlines.featureAngle);
  checkSize('outlines.creaseLength', outlines.creaseLength);
}

function checkAngle(name: string, angle = 0): void {
  if (angle >= 0 && angle <= Math.PI) return;
  throw new RangeError(
    `prepareHatchingGeometry: ${name} is ${angle}. Pass an angle in radians from 0 to π; 60 degrees is Math.PI / 3.`,
  );
}

function checkSize(name: string, size = 0, wanted = 'a length in object units, 0 or more'): void {
  if (size >= 0 && size < Infinity) return;
  throw new RangeError(`prepareHatchingGeometry: ${name} is ${String(size)}. Pass ${wanted}, or leave the option out.`);
}

/**
 * For each triangle the material index of its group plus 1, or 0 outside of all groups. Returns null if there are no groups, or if
 * one group holds all triangles.
 */
export function triangleGroups({ count, groups }: CornerRange): Uint16Array<ArrayBuffer> | null {
  if (groups.length === 0 || (groups.length === 1 && groups[0].count === count)) return null;
  const ofTriangle = new Uint16Array(count / 3);
  for (const { start, count: length, materialIndex = 0 } of groups) {
    ofTriangle.fill(1 + materialIndex, start / 3, (start + length) / 3);
  }
  return ofTriangle;
}

/**
 * Creates the new geometry with everything that the bake does not change: name, user data, groups and instanced attributes. It
 * is created before the bake starts, so that later changes of `source` have no effect.
 */
function startGeometry(source: BufferGeometry, range: CornerRange): BufferGeometry {
  const geometry = 'isInstancedBufferGeometry' in source ? new InstancedBufferGeometry() : new BufferGeometry();
  if (geometry instanceof InstancedBufferGeometry) {
    geometry.instanceCount = (source as InstancedBufferGeometry).instanceCount;
  }
  geometry.name = source.name;
  geometry.userData = { ...source.userData };
  geometry.morphTargetsRelative = source.morphTargetsRelative;
  for (const group of range.groups) geometry.addGroup(group.start, group.count, group.materialIndex);
  const clonedBuffers = {};
  for (const [name, attribute] of Object.entries(source.attributes)) {
    if (!isInstanced(attribute)) continue;
    geometry.setAttribute(name, 'data' in attribute ? attribute.clone(clonedBuffers) : attribute.clone());
  }
  return geometry;
}
