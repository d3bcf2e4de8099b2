import type { Mesh, Object3D } from 'three';
import { describeObject } from '../material/diagnostics/describeObject.js';
import { isPromise, warn } from '../material/diagnostics/warn.js';
import { identityOf } from '../material/geometry/identityOf.js';
import { startWorker } from '../worker/runTask.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { assertTree } from './assertTree.js';
import { type ChosenMeshes, chooseMeshes, type MeshHolder, sentencesOf } from './chooseMeshes.js';
import { claimMeshes, surfaceMeshes } from './surfaceMeshes.js';

/** For each root, by its identity, the call that hatches it at present. */
const underWay = new WeakMap<object, CallUnderWay>();

/** A call that hatches the meshes of a root, from the choice of the meshes to its end. The meshes are claimed meanwhile. */
export class CallUnderWay {
  private readonly stop = new AbortController();
  private readonly free: () => void;
  private promise: Promise<unknown> | undefined;
  private readonly onAbort = (): void => this.stop.abort(this.options.signal?.reason);

  /** @param choice the meshes to hatch; those that `holder` has not claimed yet are claimed */
  constructor(
    readonly root: Object3D,
    readonly options: ApplyHatchingOptions,
    readonly choice: ChosenMeshes,
    holder: MeshHolder | undefined,
  ) {
    underWay.set(identityOf(root), this);
    this.free = claimMeshes(choice.chosen.filter((mesh) => !holder?.holds(mesh)));
    // An abort frees the meshes at once: the caller may abort and apply again in the same tick, as React's StrictMode does.
    this.signal.addEventListener('abort', () => this.end());
    options.signal?.addEventListener('abort', this.onAbort);
  }

  /** Aborts what the call has started, when the caller aborts it, or when a later call for the root begins. */
  get signal(): AbortSignal {
    return this.stop.signal;
  }

  /** Gives up the claims: the call has ended. */
  end(): void {
    this.free();
    const key = identityOf(this.root);
    if (underWay.get(key) === this) underWay.delete(key);
  }

  /** Forgets the caller's signal: nothing that the call has started goes on. */
  unlink(): void {
    this.options.signal?.removeEventListener('abort', this.onAbort);
  }

  /** Names the promise of the call, and returns it. */
  promised<Result>(promise: Promise<Result>): Promise<Result> {
    this.promise = promise;
    return promise;
  }

  /** Ends the call, because a later one is to win. The rejection of its promise needs no handler. */
  giveWay(): void {
    this.promise?.catch(() => {});
    this.stop.abort(
      new DOMException('applyHatching: another call for the same root, or dispose(), has ended it.', 'AbortError'),
    );
  }
}

/**
 * Chooses the meshes to hatch at or below `root`, and claims them. An earlier call for the same root ends.
 *
 * @param holder what holds the meshes that are hatched already
 * @param detached further meshes of the holder, which are not below the root
 * @throws Error or TypeError if `root` is no tree of objects; the signal's reason if it is aborted
 */
export function beginCall(
  root: Object3D,
  options: ApplyHatchingOptions,
  holder?: MeshHolder,
  detached: readonly Mesh[] = [],
): CallUnderWay {
  options.signal?.throwIfAborted();
  if (!root?.isObject3D) {
    const remedy = isPromise(root) ? 'Write await before what loads it.' : 'For a loaded glTF pass gltf.scene.';
    throw new TypeError(`applyHatching: expected a THREE.Object3D. ${remedy}`);
  }
  assertTree('applyHatching', root);
  // The meshes of the earlier call are free when it has ended.
  underWay.get(identityOf(root))?.giveWay();
  const meshes = surfaceMeshes(root).filter(options.filter ?? (() => true));
  const choice = chooseMeshes(meshes, holder);
  choice.chosen.push(...detached);
  if (choice.chosen.length > 0) startWorker(options, isWithAdjacency(options) ? 'bakePull' : 'bakeIndexed');
  else if (!holder) warnOfNothing(root, choice);
  return new CallUnderWay(root, options, choice, holder);
}

/** Whether geometries are baked with adjacency, as far as it is known before there are materials. */
const isWithAdjacency = ({ material, adjacency }: ApplyHatchingOptions): boolean =>
  Boolean(adjacency) || (typeof material === 'object' && /^(triangle|adjacency)$/.test(material.technique ?? ''));

/** Says that nothing is hatched, and what can be done. */
function warnOfNothing(root: Object3D, { skipped, claimed }: ChosenMeshes): void {
  if (skipped.length === 0) {
    warn(
      `applyHatching: there is no mesh to hatch in the ${describeObject(root)}. Call it once the model is loaded and added, or call update() of the result then.`,
    );
    return;
  }
  const remedy =
    claimed.length > 0
      ? 'Call update() or setPreset() of the result of the first call, or dispose() of it before.'
      : 'Set userData.hatching to true on what is to be hatched all the same, and call update() of the result.';
  warn(`applyHatching: nothing is left to hatch. ${sentencesOf(skipped)} ${remedy}`);
}
