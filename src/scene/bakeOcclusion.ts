import { BackSide, type Mesh, type Object3D } from 'three';
import { assertGeometry, checkGeometry } from '../geometry/checkGeometry.js';
import { cornerRange } from '../geometry/cornerRange.js';
import { copyVectors, extractMesh } from '../geometry/extractMesh.js';
import type { OcclusionMesh } from '../occlusion/OcclusionScene.js';
import { checkOptions } from '../worker/checkOptions.js';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { assertTree } from './assertTree.js';
import type { SkippedMesh } from './HatchedScene.js';
import { hasRoom, OcclusionBake } from './OcclusionBake.js';
import { isBatched, materialsOf, surfaceMeshes } from './surfaceMeshes.js';
import { worldMatrices } from './worldMatrices.js';

/** Options of `bakeOcclusion`. */
export interface BakeOcclusionOptions extends TaskOptions {
  /**
   * How many directions every vertex is asked in, from 64 to 8192; half of them are below its surface. Time grows with them, and
   * noise falls. Default 384, which is within 0.01 of the exact values in the mean.
   */
  directions?: number | undefined;
  /**
   * Called whenever the meshes have been given a finer result, three times with the default `directions`: draw again. What it throws ends the bake.
   */
  onPass?: ((bake: OcclusionBake) => void) | undefined;
  /**
   * Called before each part of the work, of which there are two dozen with the default `directions`, and before each pass is
   * shown. Where it returns a promise, the bake goes on when that has resolved: other work may go first. What it throws or rejects
   * with ends the bake.
   */
  pause?: (() => Promise<unknown> | undefined) | undefined;
}

const OWN_OPTIONS = { directions: true, onPass: true, pause: true } satisfies Record<
  Exclude<keyof BakeOcclusionOptions, keyof TaskOptions>,
  true
>;

const DEFAULT_DIRECTIONS = 384;
/** Directions of the results before the last. The first should come soon, and not be too coarse to look at. */
const EARLY_DIRECTIONS = [64, 192];
/** Pairs of opposite directions in one request to the worker. */
const PAIRS_AT_ONCE = 8;
/** Of the progress: until the first direction. */
const START_SHARE = 0.05;

/**
 * Bakes how much of the sky every vertex sees, as `HatchingMaterial` draws it (`occlusion`): cavities, folds and contacts become
 * darker under any light. It is kept in the geometries, so a frame takes no longer. Runs in the worker. The meshes get a first
 * result soon, and better ones until the promise resolves.
 *
 * - Every mesh at or below `root` with a geometry of `prepareHatchingGeometry` gets it; meshes of `applyHatching` have one. All
 *   visible meshes there hide the sky from each other, front and back, but those that are `transparent`. Instances, batches,
 *   lines and points take no part.
 * - It is a matter of the moment: of meshes where they are, and of skins and morph targets at rest. Bake again after a change.
 * - Meshes that share a geometry get one each, which shares all but eight bytes per vertex. A mesh elsewhere that draws the same
 *   geometry shows the same occlusion.
 * - It is as fine as the mesh: a wide floor of two triangles has no place to keep a shade in. Details are lost that are
 *   smaller than about 1/250 of the size of the scene.
 *
 * Rejects with the signal's reason when aborted, and takes back what was shown; with an Error if no mesh is prepared, or one is below itself; and
 * with a TypeError or RangeError for a wrong option. When the worker dies, it begins anew.
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
    const readAll = () => ({ meshes: readers.map((read) => read()) });
    const start = (options: TaskOptions) => runTask('startOcclusion', readAll(), options, readAll);
    let scene = await start(phase(0, START_SHARE));
    const goals = [...EARLY_DIRECTIONS.filter((early) => early < directions), directions].map((goal) =>
      Math.ceil(goal / 2),
    );
    const all = goals[goals.length - 1];
    const progressAt = (pairs: number) => START_SHARE + (1 - START_SHARE) * (pairs / all);
    for (const goal of goals) {
      let occlusions: Int16Array[] = [];
      while (scene.pairs < goal) {
        await rest();
        const { pairs } = scene;
        const next = Math.min(goal, pairs + PAIRS_AT_ONCE);
        ({ scene, occlusions } = await runTask(
          'addDirections',
          { scene, pairs: next - pairs },
          phase(progressAt(pairs), progressAt(next)),
          // What was looked at before is lost with the worker.
          async () => ({ scene: await start({ signal, createWorker }), pairs: next }),
        ));
      }
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

/** Copies a mesh as it was found. */
type MeshReader = () => OcclusionMesh;

/** Checks all meshes that take part and could be read. */
function readersOf(root: Object3D): { readers: MeshReader[]; receivers: Mesh[]; skipped: SkippedMesh[] } {
  const receivers: Mesh[] = [];
  const skipped: SkippedMesh[] = [];
  const readers: MeshReader[] = [];
  for (const mesh of surfaceMeshes(root)) {
    try {
      assertGeometry(mesh.geometry, 'bakeOcclusion');
      if (isMany(mesh)) continue;
      const receives = hasRoom(mesh.geometry) && mesh.geometry.attributes.normal !== undefined;
      const hides =
        isShown(mesh, root) && materialsOf(mesh).some(({ visible, transparent }) => visible && !transparent);
      if (!receives && !hides) continue;
      readers.push(readerOf(mesh, receives, hides));
      if (receives) receivers.push(mesh);
    } catch (error) {
      skipped.push({ mesh, error: error as Error });
    }
  }
  return { readers, receivers, skipped };
}

function readerOf(mesh: Mesh, receives: boolean, hides: boolean): MeshReader {
  const { geometry } = mesh;
  const range = cornerRange(geometry, checkGeometry(geometry, 'bakeOcclusion'));
  const toWorld = worldMatrices(mesh)[0].toArray();
  const isInsideOut = materialsOf(mesh).every(({ side }) => side === BackSide);
  return () => ({
    ...extractMesh(geometry, range),
    normals: receives ? copyVectors(geometry.attributes.normal) : null,
    toWorld,
    isInsideOut,
    hides,
  });
}

/** Whether a mesh is drawn at several places. */
const isMany = (mesh: Mesh): boolean =>
  'isInstancedMesh' in mesh || 'isInstancedBufferGeometry' in mesh.geometry || isBatched(mesh);

function isShown(mesh: Mesh, root: Object3D): boolean {
  for (let object: Object3D | null = mesh; object !== null; object = object === root ? null : object.parent) {
    if (!object.visible) return false;
  }
  return true;
}
