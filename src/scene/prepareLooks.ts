import type { Mesh, Object3D } from 'three';
import { assertGeometry } from '../material/diagnostics/assertGeometry.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import type { CallUnderWay } from './beginCall.js';
import { failure } from './chooseMeshes.js';
import type { FirstFrame } from './FirstFrame.js';
import type { OldLook } from './geometryPlans.js';
import type { HatchingCall, LookMakers, MadeLooks, OldLooks } from './HatchingCall.js';
import { makeLooks } from './makeLooks.js';
import type { OutlineMaker } from './OutlineMaker.js';
import type { SkippedMesh } from './SkippedMesh.js';
import { isHatching, materialsOf } from './surfaceMeshes.js';

/** What a hatched scene tells the calls that change it. */
export type SceneState = Pick<
  HatchingCall,
  'style' | 'reusable' | 'mustHatch' | 'isDetached' | 'fieldFrameOf' | 'takeEdits' | 'asBefore'
>;

/** What a call has made for its meshes. */
export interface PreparedCall {
  made: MadeLooks;
  outlineMaker: OutlineMaker | null;
  madeMaps: HatchingCall['madeMaps'];
}

/**
 * Makes the new looks of the chosen meshes without changing the scene; null if there are none.
 *
 * | step    | what exists after it                                      | done by        |
 * | ------- | --------------------------------------------------------- | -------------- |
 * | claimed | a mark on each mesh, so that no other call hatches it      | `beginCall`    |
 * | planned | materials; for each geometry, how it is to be baked        | `makeLooks`    |
 * | made    | geometries and maps; programs that need no geometry build  | `makeLooks`    |
 * | dressed | sizes, frames of lines, outlines, levels, all programs     | `dressLooks`   |
 * | shown   | the meshes look so; the scene owns what was made           | `HatchedScene` |
 *
 * A failure or an abort before the last step frees what was made.
 */
export async function prepareLooks(
  { root, choice, options: given, signal }: CallUnderWay,
  makers: LookMakers,
  state: SceneState,
): Promise<PreparedCall | null> {
  if (choice.chosen.length === 0) return null;
  const options = { ...given, signal };
  const madeMaps: HatchingCall['madeMaps'] = [];
  const disposables: HatchingCall['disposables'] = [];
  try {
    root.updateWorldMatrix(true, false);
    root.updateMatrixWorld();
    const old = state.asBefore(() => looksToReplace(choice.chosen));
    // Code is fetched only for what is requested.
    const [firstFrame, outlineMaker, detail] = await Promise.all([
      firstFrameOf(root, options),
      outlineMakerOf(options, makers, state),
      options.detail ? import('./levelMaker.js').then(({ levelMaker }) => levelMaker(options.detail!, options)) : null,
    ]);
    if (outlineMaker) disposables.push(outlineMaker);
    signal.throwIfAborted();
    const call: HatchingCall = {
      ...state,
      root,
      options,
      makers,
      choice,
      firstFrame,
      outlineMaker,
      detail,
      disposables,
      madeMaps,
    };
    const made = await makeLooks(call, old);
    signal.throwIfAborted();
    outlineMaker?.forgetSample();
    return { made, outlineMaker, madeMaps };
  } catch (error) {
    for (const disposable of [...disposables, ...madeMaps]) disposable.dispose();
    throw error;
  }
}

async function outlineMakerOf(
  { outlines }: ApplyHatchingOptions,
  makers: LookMakers,
  { style }: SceneState,
): Promise<OutlineMaker | null> {
  if (!outlines) return null;
  return style.outlineMaker?.next() ?? makers.outlineMaker(outlines === true ? {} : outlines);
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
