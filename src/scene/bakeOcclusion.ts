import { BackSide, FrontSide, type Material, type Mesh, type Object3D, type Vector3 } from 'three';
import { assertGeometry } from '../material/diagnostics/assertGeometry.js';
import { checkGeometry } from '../material/geometry/checkGeometry.js';
import { type CornerRange, copyVectors, cornerRange, extractMesh } from '../material/geometry/extractMesh.js';
import { BACK, FRONT, type OcclusionMesh, type OcclusionScene } from '../mesh/occlusion/OcclusionScene.js';
import { runTask } from '../worker/runTask.js';
import { checkOptions, maxWorkers, type TaskOptions } from '../worker/TaskOptions.js';
import { assertTree } from './assertTree.js';
import { failure } from './chooseMeshes.js';
import { hasRoom, OcclusionBake } from './OcclusionBake.js';
import { OcclusionLanes } from './OcclusionLanes.js';
import type { SkippedMesh } from './SkippedMesh.js';
import { isBatched, materialsOf, surfaceMeshes } from './surfaceMeshes.js';
import { worldMatrices } from './worldMatrices.js';

/** Options of `bakeOcclusion`. */
export interface BakeOcclusionOptions extends TaskOptions {
  /**
   * The number of directions in which the sky is sampled, from 64 to 8192; half of them are below the surface of each vertex. More
   * directions take longer and give less noise. Default 384, with a mean error of about 0.01.
   */
  directions?: number | undefined;
  /**
   * Called whenever the meshes have a finer result, so that you can draw a frame: three times with the default `directions`. An
   * exception in it ends the bake.
   */
  onPass?: ((bake: OcclusionBake) => void) | undefined;
  /**
   * Called before each part of the work (two dozen with the default `directions`) and before each result is shown. If it returns a
   * promise, the bake waits for it, so that other work can go first. An exception or a rejection ends the bake.
   */
  pause?: (() => Promise<unknown> | undefined) | undefined;
}

const OWN_OPTIONS = { directions: true, onPass: true, pause: true } satisfies Record<
  Exclude<keyof BakeOcclusionOptions, keyof TaskOptions>,
  true
>;

const DEFAULT_DIRECTIONS = 384;
/** The numbers of directions of the results before the last. The first result comes soon, but not before its noise is acceptable. */
const EARLY_DIRECTIONS = [64, 192];
/**
 * The number of triangles above which only one worker bakes: copies of the scene, of about 40 bytes per triangle, would block the page.
 */
const LARGE_TRIANGLES = 500_000;
/** The share of the progress before the first direction. */
const START_SHARE = 0.05;

/**
 * Bakes ambient occlusion: how much of the sky each vertex sees. `HatchingMaterial` draws it (`occlusion`): cavities, folds and
 * contacts become darker under any light. It is stored in the geometries, so a frame takes no longer. The bake runs in up
 * to four workers. The meshes get a first result soon, and finer ones until the promise resolves.
 *
 * - Every mesh at or below `root` whose geometry comes from `prepareHatchingGeometry` or `applyHatching` receives occlusion. All
 *   visible meshes at or below `root` occlude, except `transparent` ones and those on no layer. Instances, batches, lines and points take no part.
 * - Each side that is drawn, as `side` of the materials says, gets the occlusion of its own. Both occlude, but where most that is seen from
 *   around are backs that are not drawn, as of a room whose walls face inward: there light falls in, as the eye does.
 * - Meshes are baked where they are at the time of the call, skins and morph targets at rest. Bake again after a change.
 * - Meshes that share a geometry each get a clone of it, which shares all but eight bytes per vertex. A mesh elsewhere with the
 *   same geometry shows the same occlusion.
 * - Occlusion is stored per vertex: a wide floor of two triangles cannot hold the shade of an object on it. Details smaller than
 *   about 1/250 of the size of the scene are lost.
 *
 * Rejects with the signal's reason when aborted, after it has removed the results that were shown; with an Error if no mesh is
 * prepared or an object is its own descendant; and with a TypeError or RangeError for a wrong option. If the worker dies, the bake
 * starts over.
 */
export async function bakeOcclusion(root: Object3D, options: BakeOcclusionOptions = {}): Promise<OcclusionBake> {
  checkOptions('bakeOcclusion', options, OWN_OPTIONS);
  const { directions = DEFAULT_DIRECTIONS, onPass, pause, onProgress, signal, createWorker } = options;
  if (!(directions >= 64 && directions <= 8192)) {
    throw new RangeError(`bakeOcclusion: directions is ${directions}. Pass a number from 64 to 8192, or leave it out.`);
  }
  if (onPass !== undefined && typeof onPass !== 'function') {
    throw new TypeError('bakeOcclusion: onPass must be a function, or left out.');
  }
  if (pause !== undefined && typeof pause !== 'function') {
    throw new TypeError('bakeOcclusion: pause must be a function, or left out.');
  }
  signal?.throwIfAborted();
  if (!root?.isObject3D) throw new TypeError('bakeOcclusion: expected a THREE.Object3D, such as a scene or a mesh.');
  assertTree('bakeOcclusion', root);
  root.updateWorldMatrix(true, false);
  root.updateMatrixWorld();
  const { readers, receivers, skipped } = readersOf(root);
  if (receivers.length === 0) {
    throw new Error(
      'bakeOcclusion: no mesh here has a geometry of prepareHatchingGeometry() to keep occlusion in. Prepare them, or call applyHatching() first.',
    );
  }
  const bake = new OcclusionBake(receivers, skipped);
  const phase = (from: number, to: number): TaskOptions => ({
    signal,
    createWorker,
    onProgress: onProgress && ((progress) => onProgress(from + (to - from) * progress)),
  });
  const rest = async (): Promise<void> => {
    await pause?.();
    signal?.throwIfAborted();
  };
  try {
    await rest();
    const origin = originOf(receivers);
    const readAll = () => ({ meshes: readers.map((read) => movedBack(read(), origin)) });
    const start = (options: TaskOptions) => runTask('startOcclusion', readAll(), options, readAll);
    const scene = await start(phase(0, START_SHARE));
    const goals = [...EARLY_DIRECTIONS.filter((early) => early < directions), directions].map((goal) =>
      Math.ceil(goal / 2),
    );
    const all = goals[goals.length - 1];
    const lanes = await OcclusionLanes.of(scene, laneCount(scene, createWorker), {
      options: { signal, createWorker },
      start: () => start({ signal, createWorker }),
      rest,
      onAdded: onProgress && ((pairs) => onProgress(START_SHARE + (1 - START_SHARE) * (pairs / all))),
    });
    for (const goal of goals) {
      const occlusions = await lanes.addUpTo(goal);
      await rest();
      bake.write(occlusions, 2 * goal);
      onPass?.(bake);
      signal?.throwIfAborted();
    }
    return bake;
  } catch (error) {
    bake.dispose();
    throw error;
  }
}

/** The number of workers that share the directions. */
function laneCount({ indices }: OcclusionScene, createWorker: TaskOptions['createWorker']): number {
  if (!createWorker && typeof Worker === 'undefined') return 1;
  return indices.length > 3 * LARGE_TRIANGLES ? 1 : maxWorkers();
}

/** Copies the data of a mesh. */
type MeshReader = () => OcclusionMesh;

/** Checks all meshes that take part in the bake, and lists those that cannot be read as skipped. */
function readersOf(root: Object3D): { readers: MeshReader[]; receivers: Mesh[]; skipped: SkippedMesh[] } {
  const receivers: Mesh[] = [];
  const skipped: SkippedMesh[] = [];
  const readers: MeshReader[] = [];
  for (const mesh of surfaceMeshes(root)) {
    try {
      assertGeometry(mesh.geometry, 'bakeOcclusion');
      if (isMany(mesh)) continue;
      const receives = hasRoom(mesh.geometry) && mesh.geometry.attributes.normal !== undefined;
      const occludes =
        mesh.layers.mask !== 0 && isShown(mesh, root) && materialsOf(mesh).some((material) => occludingSides(material));
      if (!receives && !occludes) continue;
      readers.push(readerOf(mesh, receives, occludes));
      if (receives) receivers.push(mesh);
    } catch (error) {
      skipped.push(failure(mesh, error as Error));
    }
  }
  return { readers, receivers, skipped };
}

function readerOf(mesh: Mesh, receives: boolean, occludes: boolean): MeshReader {
  const { geometry } = mesh;
  const range = cornerRange(geometry, checkGeometry(geometry, 'bakeOcclusion'));
  const toWorld = worldMatrices(mesh)[0].toArray();
  const sides = sidesOf(mesh);
  return () => ({
    ...extractMesh(geometry, range),
    normals: receives ? copyVectors(geometry.attributes.normal) : null,
    toWorld,
    sides,
    occluding: occludes ? occludingTriangles(mesh, range) : new Uint8Array(range.count / 3),
  });
}

/** For each triangle of a mesh the sides that occlude. As in three.js, groups count only with several materials. */
function occludingTriangles({ material }: Mesh, { count, groups }: CornerRange): Uint8Array<ArrayBuffer> {
  const occluding = new Uint8Array(count / 3);
  if (!Array.isArray(material)) return occluding.fill(occludingSides(material));
  for (const { start, count: length, materialIndex = 0 } of groups) {
    const drawn = material[materialIndex] as Material | undefined;
    if (drawn) occluding.fill(occludingSides(drawn), start / 3, (start + length) / 3);
  }
  return occluding;
}

/** The sides of a surface of this material that occlude: those that are drawn, unless it is see-through. */
function occludingSides({ side, visible, transparent }: Material): number {
  if (!visible || transparent) return 0;
  if (side === FrontSide) return FRONT;
  return side === BackSide ? BACK : FRONT + BACK;
}

/** The sides of a mesh that are drawn. */
function sidesOf(mesh: Mesh): OcclusionMesh['sides'] {
  const materials = materialsOf(mesh);
  if (materials.every(({ side }) => side === FrontSide)) return 'front';
  return materials.every(({ side }) => side === BackSide) ? 'back' : 'both';
}

/** The distance from the origin, in sizes of the mesh, beyond which its positions are too coarse in single precision. */
const FAR = 100;

/** The centre of the first mesh in the world, if it is far from the origin; the bake then uses it as its origin. */
function originOf([{ geometry, matrixWorld }]: readonly Mesh[]): Vector3 | undefined {
  if (!geometry.boundingSphere) geometry.computeBoundingSphere();
  const { center, radius } = geometry.boundingSphere!.clone().applyMatrix4(matrixWorld);
  return center.length() > FAR * radius ? center : undefined;
}

function movedBack(mesh: OcclusionMesh, origin: Vector3 | undefined): OcclusionMesh {
  if (!origin) return mesh;
  const toWorld = mesh.toWorld.map((value, i) => (i >= 12 && i < 15 ? value - origin.getComponent(i - 12) : value));
  return { ...mesh, toWorld };
}

/** Whether a mesh is drawn in several places. */
const isMany = (mesh: Mesh): boolean =>
  'isInstancedMesh' in mesh || 'isInstancedBufferGeometry' in mesh.geometry || isBatched(mesh);

function isShown(mesh: Mesh, root: Object3D): boolean {
  for (let object: Object3D | null = mesh; object !== null; object = object === root ? null : object.parent) {
    if (!object.visible) return false;
  }
  return true;
}
