import type { BufferGeometry } from 'three';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { checkGeometry } from './checkGeometry.js';
import { applyCorners } from './cornerGeometry.js';
import { cornerRange } from './cornerRange.js';
import { extractMesh } from './extractMesh.js';
import type { HatchingStatistics } from './HatchingStatistics.js';
import { applyIndexed } from './indexedGeometry.js';
import { startGeometry } from './preparedGeometry.js';
import { applyPull } from './pulledGeometry.js';
import { extractWords, keptAttributes } from './vertexAttributes.js';

/** Options of `prepareHatchingGeometry`. */
export interface PrepareHatchingGeometryOptions extends TaskOptions {
  /**
   * What is stored per vertex. `'corner'`: every corner carries the positions of all six adjacency vertices, 252 bytes per
   * triangle; every technique can draw it. `'pull'`: the positions lie in a texture, where a pre-pass may deform them, and
   * every corner finds its six there: 32 bytes per triangle and 16 per vertex. The same pixels, and the layout for all that
   * deforms. `'indexed'`: the geometry as it is, with eight more bytes per vertex, for techniques that need no adjacency when
   * they draw. `'auto'` (the default) is `'pull'` for a geometry with a skin or with morph targets of position or normal, and
   * `'corner'` otherwise.
   */
  layout?: 'auto' | 'corner' | 'pull' | 'indexed' | undefined;
  /**
   * Triangles whose normals differ by this angle or more, in radians from 0 to π, do not blend across their common
   * edge. The default is π/2, the paper's rule (section 3.3). It also bounds the smoothing of normals, which are
   * computed for a geometry that has none.
   */
  creaseAngle?: number | undefined;
  /**
   * The scale of `hatchNormal`, the normal that strokes are laid by, in object units: form finer than this, such as the
   * noise of a scan, does not bend strokes. Edges of the form stay sharp at any scale. The default is 0.03 times the radius
   * of the bounding sphere; 0 leaves the normals unsmoothed.
   */
  smoothingRadius?: number | undefined;
}

const PAPER_CREASE_ANGLE = Math.PI / 2;

/**
 * Makes the geometry that `HatchingMaterial` draws. Runs in a worker. Every layout has the attribute `hatchNormal`, the
 * normal at the scale of a stroke (four normalised 16-bit integers, the last is 0).
 *
 * - Layout `'corner'`: finds the three neighbours of every triangle and stores, for each corner, the positions of the six
 *   adjacency vertices (paper, section 3.2, figure 5; `cornerLayout`). Non-indexed; positions become 32-bit floats. With
 *   normal, uv, colour, instance matrix and instance colour it takes 15 of WebGL's 16 vertex attributes.
 * - Layout `'pull'`: non-indexed too; which vertices are adjacent and where they are lies in two textures that belong to
 *   the geometry and to its clones. They do not survive `toJSON`, and a `BatchedMesh` cannot draw them.
 * - Layout `'indexed'`: all vertices, with copies only of those at an edge of the form, which need a normal on either side;
 *   an index also where there was none, 16-bit where that is enough.
 *
 * The result is a new geometry of the triangles in the draw range. Every other attribute of the source is kept in its
 * type, also morph targets, groups, name and user data; smooth normals are added where there are none.
 * `userData.hatching` holds a `HatchingStatistics`. `geometry` itself is never touched.
 *
 * Vertices at exactly the same position count as one, so seams of uv or normal do not separate triangles. Border,
 * non-manifold and degenerate cases are baked so that they contribute nothing, and are counted.
 *
 * Rejects with a TypeError or RangeError that says what to repair, for: something that is not a BufferGeometry; no
 * `position`; no triangles; a count that is not a multiple of three; an index out of range; a position that is not
 * finite; an attribute shorter than `position`; an unknown option. Rejects with the signal's reason when aborted, and
 * with an Error when the worker dies or is disposed of meanwhile.
 */
export async function prepareHatchingGeometry(
  geometry: BufferGeometry,
  options: PrepareHatchingGeometryOptions = {},
): Promise<BufferGeometry> {
  options.signal?.throwIfAborted();
  const creaseAngle = options.creaseAngle ?? PAPER_CREASE_ANGLE;
  checkOptions(options, creaseAngle);
  const label = checkGeometry(geometry);
  const range = cornerRange(geometry, label);
  const kept = keptAttributes(geometry);
  const position = geometry.attributes.position;
  const prepared = startGeometry(geometry, range);
  const request = {
    label,
    mesh: extractMesh(geometry, range),
    creaseAngle,
    smoothingRadius: options.smoothingRadius,
    wantsNormals: !geometry.hasAttribute('normal'),
  };

  const layout = chooseLayout(geometry, options);
  if (layout === 'indexed') {
    const attributes = [{ name: 'position', isMorphTarget: false, attribute: position }, ...kept].map((entry) => ({
      ...entry,
      ...extractWords(entry.attribute, position.count),
    }));
    applyIndexed(prepared, attributes, await runTask('bakeIndexed', request, options));
  } else {
    const attributes = kept.map(({ attribute }) => extractWords(attribute, position.count));
    if (layout === 'pull') applyPull(prepared, kept, await runTask('bakePull', { ...request, attributes }, options));
    else applyCorners(prepared, kept, await runTask('bake', { ...request, attributes }, options));
  }
  return prepared;
}

function chooseLayout(
  { attributes, morphAttributes }: BufferGeometry,
  { layout = 'auto' }: PrepareHatchingGeometryOptions,
): HatchingStatistics['layout'] {
  if (layout !== 'auto') return layout;
  return attributes.skinIndex || morphAttributes.position || morphAttributes.normal ? 'pull' : 'corner';
}

function checkOptions(
  { layout = 'auto', smoothingRadius = 0 }: PrepareHatchingGeometryOptions,
  creaseAngle: number,
): void {
  if (!['auto', 'corner', 'pull', 'indexed'].includes(layout)) {
    throw new RangeError(
      `prepareHatchingGeometry: unknown layout '${layout}'. Use 'auto', 'corner', 'pull' or 'indexed'.`,
    );
  }
  if (!(creaseAngle >= 0 && creaseAngle <= Math.PI)) {
    throw new RangeError(
      `prepareHatchingGeometry: creaseAngle is ${creaseAngle}. Pass an angle in radians from 0 to π; 60 degrees is Math.PI / 3.`,
    );
  }
  if (!(smoothingRadius >= 0 && smoothingRadius < Infinity)) {
    throw new RangeError(
      `prepareHatchingGeometry: smoothingRadius is ${smoothingRadius}. Pass a length in object units, 0 or more, or leave the option out.`,
    );
  }
}
