import type { Mesh, Object3D } from 'three';
import type { PresetName } from '../look/presetMaterials.js';
import { assertGeometry } from '../material/diagnostics/assertGeometry.js';
import { describeObject } from '../material/diagnostics/describeObject.js';
import { isPromise, warn } from '../material/diagnostics/warn.js';
import { startWorker } from '../worker/runTask.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { resolveOptions } from './applyOptions.js';
import { assertTree } from './assertTree.js';
import { chooseMeshes, failure } from './chooseMeshes.js';
import type { FirstFrame } from './FirstFrame.js';
import type { OldLook } from './geometryPlans.js';
import type { HatchedScene, SkippedMesh } from './HatchedScene.js';
import type { HatchingCall, LookMakers, OldLooks } from './HatchingCall.js';
import { claimMeshes, isHatching, materialsOf, surfaceMeshes } from './surfaceMeshes.js';

export type { LookMakers };

/**
 * The implementation of `applyHatching` for any renderer. The scene changes in the last step only.
 *
 * | step    | what exists after it                                      | done by        |
 * | ------- | --------------------------------------------------------- | -------------- |
 * | claimed | a mark on each mesh, so that no other call hatches it      | here           |
 * | planned | materials; for each geometry, how it is to be baked        | `makeLooks`    |
 * | made    | geometries and maps; programs that need no geometry build  | `makeLooks`    |
 * | dressed | sizes, frames of lines, outlines, levels, all programs     | `dressLooks`   |
 * | shown   | a `HatchedScene`, which owns what was made and the marks   | `HatchedScene` |
 *
 * A failure or an abort at any step before `shown` frees what was made. An abort takes the marks away at once, not when the work has
 * stopped: the caller may abort and apply again in the same tick, as React's StrictMode does.
 */
export async function hatchScene(
  root: Object3D,
  given: ApplyHatchingOptions | PresetName,
  makers: LookMakers,
): Promise<HatchedScene> {
  const options = resolveOptions(given);
  const { replaces, signal, outlines } = options;
  signal?.throwIfAborted();
  const choice = chooseMeshes(meshesIn(root, options), replaces);
  if (choice.chosen.length > 0) startWorker(options);
  const release = claimMeshes(choice.chosen.filter((mesh) => !replaces?.holds(mesh)));
  signal?.addEventListener('abort', release);
  const disposables: HatchingCall['disposables'] = [];
  try {
    root.updateWorldMatrix(true, false);
    root.updateMatrixWorld();
    const asBefore = <Result>(work: () => Result): Result => (replaces ? replaces.suspended(work) : work());
    const old = asBefore(() => looksToReplace(choice.chosen));
    // Code is fetched only for what is requested.
    const [{ makeLooks }, firstFrame, outlineMaker, detail] = await Promise.all([
      import('./makeLooks.js'),
      firstFrameOf(root, options),
      outlines ? makers.outlineMaker(outlines === true ? {} : outlines) : null,
      options.detail ? import('./levelMaker.js').then(({ levelMaker }) => levelMaker(options.detail!, options)) : null,
    ]);
    if (outlineMaker) disposables.push(outlineMaker);
    const call = { root, options, makers, firstFrame, outlineMaker, detail, disposables, asBefore };
    const show = await makeLooks(call, old, choice);
    replaces?.dispose();
    release();
    return show();
  } catch (error) {
    for (const disposable of disposables) disposable.dispose();
    throw error;
  } finally {
    release();
    signal?.removeEventListener('abort', release);
  }
}

/** The meshes to hatch at or below `root`. @throws Error or TypeError if it is no tree of objects */
function meshesIn(root: Object3D, options: ApplyHatchingOptions): Mesh[] {
  if (!root?.isObject3D) {
    const remedy = isPromise(root) ? 'Write await before what loads it.' : 'For a loaded glTF pass gltf.scene.';
    throw new TypeError(`applyHatching: expected a THREE.Object3D. ${remedy}`);
  }
  assertTree('applyHatching', root);
  const meshes = surfaceMeshes(root).filter(options.filter ?? (() => true));
  // A caller that passes `replaces`, even as undefined, tracks a scene that may be empty at first.
  if (meshes.length === 0 && !('replaces' in options)) {
    warn(
      `applyHatching: there is no mesh to hatch in the ${describeObject(root)}. Call it once the model is loaded and added.`,
    );
  }
  return meshes;
}

async function firstFrameOf(root: Object3D, { renderer, camera }: ApplyHatchingOptions): Promise<FirstFrame | null> {
  if (!renderer || !camera) return null;
  const { FirstFrame } = await import('./FirstFrame.js');
  return new FirstFrame(renderer, camera, root);
}

/** Collects the looks of all meshes that do not have a `HatchingMaterial` yet, and those meshes that have no geometry. */
function looksToReplace(meshes: readonly Mesh[]): OldLooks {
  const seen: OldLook[] = [];
  const unreadable: SkippedMesh[] = [];
  for (const mesh of meshes) {
    if (materialsOf(mesh).every(isHatching)) continue;
    try {
      assertGeometry(mesh.geometry, 'applyHatching');
      seen.push({ mesh, geometry: mesh.geometry, oldMaterial: mesh.material });
    } catch (error) {
      unreadable.push(failure(mesh, error as Error));
    }
  }
  return { seen, unreadable };
}
