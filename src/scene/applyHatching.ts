import type { BufferGeometry, Material, Mesh, Object3D } from 'three';
import { assertGeometry } from '../geometry/checkGeometry.js';
import type { PrepareHatchingGeometryOptions } from '../geometry/prepareHatchingGeometry.js';
import { needsMap } from '../material/facts/lookFacts.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { fetchPartsOf } from '../material/parts/parts.js';
import { describeObject } from '../mistakes/describeObject.js';
import { isPromise } from '../mistakes/isPromise.js';
import { mustBeAwaited } from '../mistakes/mustBeAwaited.js';
import { tell } from '../mistakes/tell.js';
import type { HatchingOutlines } from '../outlines/HatchingOutlines.js';
import { runSliced } from '../slices/runSliced.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import { startWorker } from '../worker/runTask.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { prepareOptions, resolveOptions } from './applyOptions.js';
import { assertTree } from './assertTree.js';
import { bakeGeometries } from './bakeGeometries.js';
import { type ChosenMeshes, chooseMeshes } from './chooseMeshes.js';
import { claimMeshes } from './claimMeshes.js';
import type { MakeLevels } from './detail/levelMaker.js';
import type { FirstFrame } from './FirstFrame.js';
import { failure } from './failure.js';
import { geometryPlans, type OldLook, type PlannedMesh } from './geometryPlans.js';
import type { HatchedScene, SkippedMesh } from './HatchedScene.js';
import type { GeometryPlan } from './jointForms/FormGroup.js';
import type { LaterForms } from './LaterForms.js';
import type { MaterialFollower } from './MaterialFollower.js';
import { MaterialReplacer } from './MaterialReplacer.js';
import type { MeshLook } from './MeshLook.js';
import { isToBeMade, makeMaps } from './makeMaps.js';
import type { OutlineMaker } from './OutlineMaker.js';
import type { PresetName } from './presets.js';
import { progressParts } from './progressParts.js';
import { sideBySide } from './sideBySide.js';
import { isHatching, materialsOf, surfaceMeshes } from './surfaceMeshes.js';
import { worldMatrices, worldScale } from './worldMatrices.js';

/** What `makeLooks` returns: the content of a `HatchedScene`. */
interface MadeLooks {
  looks: MeshLook[];
  materials: HatchingMaterial[];
  outlines: HatchingOutlines[];
  skipped: SkippedMesh[];
  followers: MaterialFollower[];
  forms: LaterForms | null;
  /** Has levels of detail drawn; what it returns ends that. */
  showDetail: (() => () => void) | undefined;
  HatchedScene: typeof HatchedScene;
}

/** What is to be baked for meshes, and, if lines follow the form anywhere, what makes the object that bakes them later. */
interface PlannedBakes {
  planned: readonly PlannedMesh[];
  plans: Map<BufferGeometry, GeometryPlan>;
  formsLater?: (
    prepare: PrepareHatchingGeometryOptions,
    disposables: { dispose(): void }[],
    drawing: { firstFrame: FirstFrame | null; detail: MakeLevels | null },
  ) => LaterForms;
}

/** What users ask of a hatched scene first. */
const ASKED_OF_SCENES = ['materials', 'outlines', 'skipped', 'restore', 'dispose'] as const;

/** The share of the progress for the map, if one is made. */
const MAP_SHARE = 0.2;

/** The share of the progress for the first frame, if a renderer is given. */
const FRAME_SHARE = 0.1;

/** The share of the progress for levels of detail, if they are asked for. */
const DETAIL_SHARE = 0.2;

/**
 * Hatches a whole scene, such as a loaded glTF. The geometry of every mesh at or below `root` is baked, a shared geometry only
 * once. Every material is replaced by a `HatchingMaterial` with the same colour, maps, opacity, sides and vertex colours.
 * Instances, groups, skins and morph targets keep working; lines, points and sprites are left alone. The scene does not change
 * before everything is ready, and not at all if that fails or is aborted. After an abort it can be hatched again at once.
 *
 *     await applyHatching(gltf.scene, 'pencil');
 *
 * With the options `renderer` and `camera` the promise also waits for the programs and the upload, so that the first frame is
 * drawn at once: add `root` and the lights to the scene before. Without them call `renderer.compileAsync(scene, camera)` afterwards.
 *
 * - A material that meshes share becomes one shared material. If the meshes differ in scale, there is one material per scale,
 *   because `tilesPerUnit` refers to object space. Meshes that deform get a material of their own.
 * - Meshes that already have a `HatchingMaterial` are left alone.
 * - `skipped` lists the meshes that were left alone, each with the reason: those whose material is a `ShaderMaterial`, has an
 *   `onBeforeCompile` of its own or shows a render target, as helpers such as grids, mirrors, text and contact shadows do; those
 *   with `userData.hatching` set to false, or below an object that has it (true hatches the mesh whatever its material is); those
 *   that are hatched already, so that after meshes were added another call hatches them; and, with an `error`, those whose
 *   geometry cannot be baked or whose geometry or material was replaced during the call.
 * - Lines of `engraved` continue from mesh to mesh: `userData.hatchingField` of each mesh holds the coordinate frame that they
 *   share, as it is at the time of the call. Clones keep it. Instances and batches have separate lines. Lines that follow the form
 *   continue where the borders of meshes meet.
 * - Geometries that `triangle` or `adjacency` draws are baked with adjacency, the others without, unless `adjacency` asks for it.
 *   No map is drawn for materials that need none.
 * - `outlines` draws contours, borders and creases of every mesh except `BatchedMesh` and cut-outs (`alphaTest`, `alphaHash`).
 * - A `BatchedMesh` keeps its geometry. `anchored` hatches it with the normals that it has; other techniques can draw it only if
 *   it was filled with prepared geometries.
 *
 * The promise is rejected
 *
 * - with an Error that says what was there, if every mesh is left alone on purpose, for instance because all are hatched already;
 * - with an Error if an object is its own descendant;
 * - with a RangeError for an unknown preset or an option out of its range, and with a TypeError for an unknown option;
 * - with a TypeError that names the first meshes, if none of those that were to be hatched could be; its `cause` is the first error;
 * - with the error of the map or of a parameter;
 * - with the signal's reason when aborted.
 */
export function applyHatching(root: Object3D, options: ApplyHatchingOptions | PresetName = {}): Promise<HatchedScene> {
  return mustBeAwaited(hatch(root, options), 'applyHatching()', ASKED_OF_SCENES);
}

async function hatch(root: Object3D, given: ApplyHatchingOptions | PresetName): Promise<HatchedScene> {
  const options = resolveOptions(given);
  options.signal?.throwIfAborted();
  if (!root?.isObject3D) {
    const remedy = isPromise(root) ? 'Write await before what loads it.' : 'For a loaded glTF pass gltf.scene.';
    throw new TypeError(`applyHatching: expected a THREE.Object3D. ${remedy}`);
  }
  assertTree('applyHatching', root);
  const { replaces, signal } = options;
  const meshes = surfaceMeshes(root).filter(options.filter ?? (() => true));
  // Whoever says what to replace, even if it is nothing, follows a scene that may be empty at first.
  if (meshes.length === 0 && !('replaces' in options)) {
    tell(
      `applyHatching: there is no mesh to hatch in the ${describeObject(root)}. Call it once the model is loaded and added.`,
    );
  }
  const choice = chooseMeshes(meshes, replaces);
  if (choice.chosen.length > 0) startWorker(options);
  let releaseMeshes = claimMeshes(choice.chosen.filter((mesh) => !replaces?.holds(mesh)));
  const onAbort = (): void => releaseMeshes();
  // The meshes are released at once, not when the work has stopped: the caller may abort and apply again in the same tick, as
  // React's StrictMode does.
  signal?.addEventListener('abort', onAbort);
  const disposables: { dispose(): void }[] = [];
  try {
    root.updateWorldMatrix(true, false);
    root.updateMatrixWorld();
    const made = await makeLooks(root, choice, options, disposables);
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
      for (const material of materialsOf(mesh)) if (isHatching(material)) material.announce(mesh);
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

/** Makes the new looks of meshes. The scene does not change. Everything that must be freed is added to `disposables`. */
async function makeLooks(
  root: Object3D,
  { chosen, skipped: leftAlone, claimed }: ChosenMeshes,
  options: ApplyHatchingOptions,
  disposables: { dispose(): void }[],
): Promise<MadeLooks> {
  const { replaces, signal, tilesPerWorldUnit, onGeometry, onProgress } = options;
  const asBefore = <Result>(work: () => Result): Result => (replaces ? replaces.suspended(work) : work());
  const replacer = new MaterialReplacer(options.material ?? {});
  disposables.push(replacer);
  const { seen, unreadable } = asBefore(() => looksToReplace(chosen));
  const [{ planned, plans, formsLater }, firstFrame, outlineMaker, detail] = await Promise.all([
    runSliced(planMeshes(seen, replacer), { signal, around: asBefore }).then((all) => planBakes(all, options)),
    firstFrameOf(root, options),
    outlineMakerOf(options),
    detailOf(options),
  ]);
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
  // What dresses the meshes is fetched while they are baked.
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
      const [dressing] = await Promise.all([import('./dressing/dressing.js'), ...replacer.materials.map(fetchPartsOf)]);
      asBefore(() => firstFrame?.compile(planned, outlineMaker?.samples ?? [], false));
      return dressing;
    },
  );
  forms?.drawMeanwhile(baked);
  const { assertNoFailure, changedMeanwhile, collectLooks, finishLooks, HatchedScene, hasChanged } = dressing;
  const { looks, skipped } = asBefore(() => collectLooks(planned, baked));
  skipped.push(...unreadable);
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
    skipped: [...leftAlone, ...skipped],
    followers: replacer.followers,
    forms,
    showDetail,
    HatchedScene,
  };
}

/** What prepares the first frame, if there is a renderer for it. Pages that give none do not load it. */
async function firstFrameOf(root: Object3D, { renderer, camera }: ApplyHatchingOptions): Promise<FirstFrame | null> {
  if (!renderer || !camera) return null;
  const { FirstFrame } = await import('./FirstFrame.js');
  return new FirstFrame(renderer, camera, root);
}

/** Plans the bakes of meshes, those with lines along the form in groups. Scenes without such lines do not load what bakes these later. */
async function planBakes(planned: readonly PlannedMesh[], options: ApplyHatchingOptions): Promise<PlannedBakes> {
  const plans = geometryPlans(planned, options);
  if ([...plans.values()].every(({ form }) => !form)) return { planned, plans };
  const [{ LaterForms }, { crossingMaterials, formGroups }] = await Promise.all([
    import('./LaterForms.js'),
    import('./jointForms/groups.js'),
  ]);
  const groups = await runSliced(formGroups(planned, plans), { signal: options.signal });
  for (const [geometry, plan] of plans) plan.group = groups.get(geometry);
  const crossing = crossingMaterials(planned, options);
  return {
    planned,
    plans,
    formsLater: (prepare, ...others) => new LaterForms(plans, crossing, prepare, options, ...others),
  };
}

/** What makes levels of detail, if they are asked for. Scenes without them do not load it. @throws TypeError for a wrong option */
async function detailOf(options: ApplyHatchingOptions): Promise<MakeLevels | null> {
  return options.detail ? (await import('./detail/levelMaker.js')).levelMaker(options.detail, options) : null;
}

/** What makes outlines, if they are asked for. Scenes without them do not load it. @throws RangeError or TypeError for a wrong parameter */
async function outlineMakerOf({ outlines }: ApplyHatchingOptions): Promise<OutlineMaker | null> {
  if (!outlines) return null;
  const { OutlineMaker } = await import('./OutlineMaker.js');
  return new OutlineMaker(outlines === true ? {} : outlines);
}

/** Collects the looks of all meshes that do not have a `HatchingMaterial` yet, and those meshes that have no geometry. */
function looksToReplace(meshes: readonly Mesh[]): { seen: OldLook[]; unreadable: SkippedMesh[] } {
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

/** Makes the materials that the meshes will get. It yields after each mesh, since a scene may have thousands of materials. */
function* planMeshes(looks: readonly OldLook[], replacer: MaterialReplacer): Generator<number, PlannedMesh[], void> {
  const planned: PlannedMesh[] = [];
  for (const look of looks) {
    const scale = worldScale(worldMatrices(look.mesh));
    planned.push({ ...look, material: replacer.replacementFor(look.mesh, look.oldMaterial, scale) });
    yield planned.length / looks.length;
  }
  return planned;
}
