import type { BufferGeometry, Material, Mesh, Object3D } from 'three';
import { needsMap } from '../look/queries.js';
import { assertGeometry } from '../material/diagnostics/assertGeometry.js';
import { describeObject } from '../material/diagnostics/describeObject.js';
import { isPromise } from '../material/diagnostics/mustBeAwaited.js';
import { warn } from '../material/diagnostics/warn.js';
import type {
  OutlineOptions,
  PrepareHatchingGeometryOptions,
} from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingOutlineParameters } from '../material/outlines/HatchingOutlineMaterial.js';
import type { HatchingOutlines } from '../material/outlines/HatchingOutlines.js';
import { runSliced } from '../mesh/phases.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import { startWorker } from '../worker/runTask.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { isToBeMade, prepareOptions, resolveOptions } from './applyOptions.js';
import { assertTree } from './assertTree.js';
import { type ChosenMeshes, chooseMeshes, claimMeshes, failure } from './chooseMeshes.js';
import type { FirstFrame } from './FirstFrame.js';
import type { GeometryPlan, MeshLook, OldLook, PlannedMesh } from './geometryPlans.js';
import type { HatchedScene, SkippedMesh } from './HatchedScene.js';
import type { LaterForms } from './LaterForms.js';
import type { MakeLevels } from './levelMaker.js';
import type { MaterialFollower, MaterialReplacer } from './MaterialReplacer.js';
import type { OutlineMaker } from './OutlineMaker.js';
import type { PresetName } from './presets.js';
import { isHatching, materialsOf, surfaceMeshes } from './surfaceMeshes.js';

/** The result of `makeLooks`: the content of a `HatchedScene`. */
interface MadeLooks {
  looks: MeshLook[];
  materials: HatchingMaterial[];
  outlines: HatchingOutlines[];
  skipped: SkippedMesh[];
  followers: MaterialFollower[];
  forms: LaterForms | null;
  /** Starts to draw levels of detail; the returned function ends it. */
  showDetail: (() => () => void) | undefined;
  HatchedScene: typeof HatchedScene;
}

/** The former looks of meshes, and the meshes that cannot be read. */
interface OldLooks {
  seen: OldLook[];
  unreadable: SkippedMesh[];
}

/**
 * The new materials of meshes, the geometries to bake, and, if lines follow the form anywhere, a factory of the object that bakes
 * fields later.
 */
interface Planning {
  making: typeof import('./making/making.js');
  replacer: MaterialReplacer;
  planned: readonly PlannedMesh[];
  plans: Map<BufferGeometry, GeometryPlan>;
  formsLater?: (
    prepare: PrepareHatchingGeometryOptions,
    disposables: { dispose(): void }[],
    drawing: { firstFrame: FirstFrame | null; detail: MakeLevels | null },
  ) => LaterForms;
}

/** The share of the progress for the map, if one is generated. */
const MAP_SHARE = 0.2;

/** The share of the progress for the first frame, if a renderer is given. */
const FRAME_SHARE = 0.1;

/** The share of the progress for levels of detail, if they are requested. */
const DETAIL_SHARE = 0.2;

/** Makes materials and outlines for one kind of renderer. */
export interface LookMakers<Made extends HatchingMaterial = HatchingMaterial> {
  /** Makes a material with default values. */
  material(): Made;
  /** Fetches the code that a material needs, if it is loaded separately. */
  fetchPartsOf(material: Made): Promise<void>;
  /** Makes outlines. @throws RangeError or TypeError for a wrong parameter */
  outlineMaker(parameters: OutlineOptions & HatchingOutlineParameters): Promise<OutlineMaker>;
}

/** The implementation of `applyHatching` for any renderer. */
export async function hatchScene(
  root: Object3D,
  given: ApplyHatchingOptions | PresetName,
  makers: LookMakers,
): Promise<HatchedScene> {
  const options = resolveOptions(given);
  options.signal?.throwIfAborted();
  if (!root?.isObject3D) {
    const remedy = isPromise(root) ? 'Write await before what loads it.' : 'For a loaded glTF pass gltf.scene.';
    throw new TypeError(`applyHatching: expected a THREE.Object3D. ${remedy}`);
  }
  assertTree('applyHatching', root);
  const { replaces, signal } = options;
  const meshes = surfaceMeshes(root).filter(options.filter ?? (() => true));
  // A caller that passes `replaces`, even as undefined, tracks a scene that may be empty at first.
  if (meshes.length === 0 && !('replaces' in options)) {
    warn(
      `applyHatching: there is no mesh to hatch in the ${describeObject(root)}. Call it once the model is loaded and added.`,
    );
  }
  const choice = chooseMeshes(meshes, replaces);
  if (choice.chosen.length > 0) startWorker(options);
  let releaseMeshes = claimMeshes(choice.chosen.filter((mesh) => !replaces?.holds(mesh)));
  const onAbort = (): void => releaseMeshes();
  // The meshes are released at once, not when the work has stopped: the caller may abort and apply again in the same tick, as React's
  // StrictMode does.
  signal?.addEventListener('abort', onAbort);
  const disposables: { dispose(): void }[] = [];
  try {
    root.updateWorldMatrix(true, false);
    root.updateMatrixWorld();
    const made = await makeLooks(root, choice, options, makers, disposables);
    const { looks, materials, outlines, skipped, followers, forms, showDetail, HatchedScene } = made;
    replaces?.dispose();
    releaseMeshes();
    const releaseLooks = claimMeshes(looks.map(({ mesh }) => mesh));
    const hideDetail = showDetail?.();
    releaseMeshes = () => {
      hideDetail?.();
      releaseLooks();
    };
    const scene = new HatchedScene(looks, materials, outlines, skipped, followers, disposables, releaseMeshes, forms);
    for (const { mesh } of looks) {
      for (const material of materialsOf(mesh)) if (isHatching(material)) material.announce?.(mesh);
    }
    return scene;
  } catch (error) {
    for (const disposable of disposables) disposable.dispose();
    releaseMeshes();
    throw error;
  } finally {
    signal?.removeEventListener('abort', onAbort);
  }
}

/** Makes the new looks of meshes without changing the scene. Everything that must be freed is added to `disposables`. */
async function makeLooks(
  root: Object3D,
  { chosen, skipped: leftAlone, claimed }: ChosenMeshes,
  options: ApplyHatchingOptions,
  makers: LookMakers,
  disposables: { dispose(): void }[],
): Promise<MadeLooks> {
  const { replaces, signal, tilesPerWorldUnit, onGeometry, onProgress } = options;
  const asBefore = <Result>(work: () => Result): Result => (replaces ? replaces.suspended(work) : work());
  const old = asBefore(() => looksToReplace(chosen));
  const [{ making, replacer, planned, plans, formsLater }, firstFrame, outlineMaker, detail] = await Promise.all([
    plan(old, options, makers, disposables, asBefore),
    firstFrameOf(root, options),
    outlineMakerOf(options, makers),
    detailOf(options),
  ]);
  const { bakeGeometries, makeMaps, progressParts, sideBySide } = making;
  if (outlineMaker) disposables.push(outlineMaker);

  const named = replacer.materials.filter((material) => typeof material.tonalArtMap === 'string' && needsMap(material));
  const styles = [...new Set(named.map(({ tonalArtMap }) => tonalArtMap as StrokeStyleName))];
  const isMapMade = styles.length > 0 && (options.tonalArtMap === undefined || isToBeMade(options.tonalArtMap));
  const mapShare = isMapMade ? MAP_SHARE : 0;
  const frameShare = firstFrame ? FRAME_SHARE : 0;
  const detailShare = detail ? DETAIL_SHARE : 0;
  const bakeShare = 1 - mapShare - frameShare - detailShare;
  const [onBake, onMap, onFrame, onDetail] = progressParts(onProgress, [bakeShare, mapShare, frameShare, detailShare]);
  const prepare = { ...prepareOptions(options), outlines: outlineMaker?.creases ?? false };
  const forms = formsLater?.(prepare, disposables, { firstFrame, detail }) ?? null;
  // The code that applies looks is fetched while geometries are baked.
  const [baked, maps, dressing] = await sideBySide(
    signal,
    (stop) =>
      bakeGeometries(
        forms?.atOnce ?? plans,
        { ...prepare, onProgress: onBake, signal: stop },
        { onBaked: (geometry) => disposables.push(geometry), onCount: onGeometry },
      ),
    (stop) => makeMaps(options.tonalArtMap, styles, { ...options, onProgress: onMap, signal: stop }, disposables),
    async () => {
      const [dressing] = await Promise.all([
        import('./making/dressing.js'),
        ...replacer.materials.map(makers.fetchPartsOf),
      ]);
      asBefore(() => firstFrame?.compile(planned, outlineMaker?.samples ?? [], false));
      return dressing;
    },
  );
  forms?.drawMeanwhile(baked);
  const { assertNoFailure, changedMeanwhile, collectLooks, finishLooks, HatchedScene, hasChanged } = dressing;
  const { looks, skipped } = asBefore(() => collectLooks(planned, baked));
  skipped.push(...old.unreadable);
  if (looks.length === 0) assertNoFailure(skipped);
  for (const material of named) material.tonalArtMap = maps.get(material.tonalArtMap as StrokeStyleName) ?? null;
  signal?.throwIfAborted();
  const finishing = finishLooks(root, { looks, claimed }, replacer, { tilesPerWorldUnit, outlineMaker });
  const allOutlines = await runSliced(finishing, { signal });
  const showDetail = await detail?.(looks, onDetail);
  if (firstFrame) {
    firstFrame.compile(looks, allOutlines, true);
    await runSliced(firstFrame.upload(looks), { signal, onProgress: onFrame });
    await firstFrame.built(signal);
    onFrame?.(1);
  }

  const changed = new Set(asBefore(() => planned.filter(hasChanged)).map(({ mesh }) => mesh));
  const kept = looks.filter(({ mesh }) => !changed.has(mesh));
  for (const { mesh } of looks) if (changed.has(mesh)) skipped.push(changedMeanwhile(mesh));
  if (kept.length === 0) assertNoFailure(skipped);
  const used = new Set<Material>(kept.flatMap(({ material }) => material));
  return {
    looks: kept,
    materials: replacer.materials.filter((material) => used.has(material)),
    outlines: allOutlines.filter(({ mesh }) => !changed.has(mesh!)),
    skipped: [...leftAlone, ...skipped, ...(outlineMaker?.without ?? [])],
    followers: replacer.followers,
    forms,
    showDetail,
    HatchedScene,
  };
}

/** Creates the object that prepares the first frame, if a renderer is given; otherwise its code is not loaded. */
async function firstFrameOf(root: Object3D, { renderer, camera }: ApplyHatchingOptions): Promise<FirstFrame | null> {
  if (!renderer || !camera) return null;
  const { FirstFrame } = await import('./FirstFrame.js');
  return new FirstFrame(renderer, camera, root);
}

/**
 * Makes the materials of meshes, and plans their bakes, in groups if lines follow the form. Without such lines the code that bakes
 * fields later is not loaded.
 */
async function plan(
  { seen, unreadable }: OldLooks,
  options: ApplyHatchingOptions,
  makers: LookMakers,
  disposables: { dispose(): void }[],
  asBefore: <Result>(work: () => Result) => Result,
): Promise<Planning> {
  const making = await import('./making/making.js');
  const replacer = new making.MaterialReplacer(options.material ?? {}, makers.material);
  disposables.push(replacer);
  const displaced = await making.displaceMeshes(seen, unreadable);
  const planned = await runSliced(making.planMeshes(displaced, replacer), { signal: options.signal, around: asBefore });
  const plans = making.geometryPlans(planned, options);
  const planning = { making, replacer, planned, plans };
  if ([...plans.values()].every(({ form }) => !form)) return planning;
  const [{ crossingMaterials, LaterForms }, { formGroups }] = await Promise.all([
    import('./LaterForms.js'),
    import('./jointForms.js'),
  ]);
  const groups = await runSliced(formGroups(planned, plans), { signal: options.signal });
  for (const [geometry, plan] of plans) plan.group = groups.get(geometry);
  const crossing = crossingMaterials(planned, options);
  return {
    ...planning,
    formsLater: (prepare, ...others) => new LaterForms(plans, crossing, prepare, options, ...others),
  };
}

/**
 * The function that makes levels of detail, if they are requested; otherwise its code is not loaded. @throws TypeError for a wrong
 * option
 */
async function detailOf(options: ApplyHatchingOptions): Promise<MakeLevels | null> {
  return options.detail ? (await import('./levelMaker.js')).levelMaker(options.detail, options) : null;
}

/**
 * The object that makes outlines, if they are requested; otherwise its code is not loaded. @throws RangeError or TypeError for a wrong
 * parameter
 */
async function outlineMakerOf({ outlines }: ApplyHatchingOptions, makers: LookMakers): Promise<OutlineMaker | null> {
  return outlines ? makers.outlineMaker(outlines === true ? {} : outlines) : null;
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
