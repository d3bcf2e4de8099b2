import { type BufferGeometry, type Material, type Mesh, type Object3D, Sphere } from 'three';
import { cornerLayout } from '../bake/cornerLayout.js';
import { assertGeometry } from '../geometry/checkGeometry.js';
import { checkPrepareOptions, type PrepareHatchingGeometryOptions } from '../geometry/prepareHatchingGeometry.js';
import type { HatchingLines } from '../lines/HatchingLines.js';
import { checkTonalArtMap, isTonalArtMap } from '../material/checkTonalArtMap.js';
import { needsAdjacency, needsMap } from '../material/lookFacts.js';
import { runSliced } from '../slices/runSliced.js';
import { checkHatchImageOptions } from '../tam/checkHatchImageOptions.js';
import { TonalArtMap } from '../tam/TonalArtMap.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { assertTree } from './assertTree.js';
import { bakeGeometries } from './bakeGeometries.js';
import { claimMeshes } from './claimMeshes.js';
import { fieldFrames } from './fieldFrames.js';
import { HatchedScene, type MeshLook, type SkippedMesh } from './HatchedScene.js';
import { LineMaker } from './LineMaker.js';
import { isHatching, MaterialReplacer } from './MaterialReplacer.js';
import type { PresetName } from './presets.js';
import { isBatched, materialsOf, surfaceMeshes } from './surfaceMeshes.js';
import { withPreset } from './withPreset.js';
import { worldMatrices, worldScale } from './worldMatrices.js';

/** The names of the options that `prepareHatchingGeometry` has not. */
const OWN_OPTIONS = {
  tonalArtMap: true,
  material: true,
  strokeScale: true,
  filter: true,
  onGeometry: true,
  preset: true,
  replaces: true,
} satisfies Record<Exclude<keyof ApplyHatchingOptions, keyof PrepareHatchingGeometryOptions>, true>;

/** A mesh to hatch, with its present geometry and material. */
interface OldLook {
  mesh: Mesh;
  geometry: BufferGeometry;
  oldMaterial: Material | Material[];
}

/** The same with the material it will get. */
interface PlannedMesh extends OldLook {
  material: Material | Material[];
}

const TILES_PER_RADIUS = 3;
/** Share of the progress for the map, if one is made. */
const MAP_SHARE = 0.2;

/**
 * Hatches a whole scene, such as a loaded glTF. Bakes the geometry of every mesh at or below `root`, a shared geometry once.
 * Replaces every material by a `HatchingMaterial` with its colour, maps, opacity, sides and vertex colours. Instances,
 * groups, skins and morph targets keep working; lines, points and sprites are left alone. Nothing in the scene changes before
 * everything is ready, and nothing at all if that fails or is aborted. Once aborted, the scene can be hatched again at once.
 *
 *     await applyHatching(gltf.scene, 'pencil');
 *
 * `await renderer.compileAsync(scene, camera)` afterwards builds every program that the first frame uses.
 *
 * - A material shared by meshes becomes one shared material. If the meshes differ in scale, it becomes one per scale, since
 *   `strokeScale` counts in object space. Meshes that deform get a material of their own.
 * - Meshes that already have a `HatchingMaterial` are left alone.
 * - A mesh whose geometry cannot be baked stays as it is and is listed in `skipped`. So is a mesh whose geometry or material
 *   was exchanged meanwhile.
 * - Lines of `engraved` run on from mesh to mesh: `userData.hatchingField` of each holds the frame they share, as at the time of
 *   the call. Clones keep it. Instances and batches have lines of their own.
 * - Unless given, the layout is `'indexed'` for geometries that only `anchored` or `engraved` draws, and no map is drawn for the
 *   latter.
 * - `lines` draws contours, borders and creases of every mesh but a `BatchedMesh` and cut-outs (`alphaTest`,
 *   `alphaHash`).
 * - A `BatchedMesh` keeps its geometry. `anchored` hatches it with the normals it has; other techniques can draw it only if it
 *   was filled with prepared geometries.
 *
 * Rejects with an Error if part of `root` is hatched already, or below itself; with a RangeError for an unknown preset; with the signal's reason when aborted; with the first mesh's
 * error if none can be hatched; with a TypeError for an unknown option; and with the error of a map or a parameter.
 */
export async function applyHatching(
  root: Object3D,
  given: ApplyHatchingOptions | PresetName = {},
): Promise<HatchedScene> {
  const named: ApplyHatchingOptions = typeof given === 'string' ? { preset: given } : given;
  checkPrepareOptions('applyHatching', named, OWN_OPTIONS);
  const options = named.preset === undefined ? named : withPreset(named.preset, named);
  checkOwnOptions(options);
  options.signal?.throwIfAborted();
  if (!root?.isObject3D) {
    throw new TypeError('applyHatching: expected a THREE.Object3D. For a loaded glTF pass gltf.scene.');
  }
  assertTree('applyHatching', root);
  const { replaces } = options;
  const meshes = surfaceMeshes(root).filter(options.filter ?? (() => true));
  let releaseMeshes = claimMeshes(meshes.filter((mesh) => !replaces?.holds(mesh)));
  const onAbort = (): void => releaseMeshes();
  // At once, not when the work has stopped: whoever aborts may apply again in the same breath, as React's StrictMode does.
  options.signal?.addEventListener('abort', onAbort);
  const asBefore = <Result>(work: () => Result): Result => (replaces ? replaces.suspended(work) : work());
  const disposables: { dispose(): void }[] = [];
  try {
    root.updateWorldMatrix(true, false);
    root.updateMatrixWorld();
    const replacer = new MaterialReplacer(options.material ?? {});
    disposables.push(replacer);
    const { seen, unreadable } = asBefore(() => looksToReplace(meshes));
    const planned = await runSliced(planMeshes(seen, replacer), { signal: options.signal, around: asBefore });

    const withoutMap = replacer.materials.filter((one) => one.tonalArtMap === null && needsMap(one));
    const { tonalArtMap: wanted = {} } = options;
    const isDrawn = withoutMap.length > 0 && isToBeMade(wanted);
    const mapShare = isDrawn ? MAP_SHARE : 0;
    const {
      preset: _preset,
      replaces: _replaces,
      tonalArtMap: _map,
      material: _material,
      strokeScale,
      filter: _filter,
      lines,
      onGeometry,
      ...baking
    } = options;
    const lineMaker = lines ? new LineMaker(lines === true ? {} : lines) : null;
    const { onProgress, signal, createWorker } = baking;
    const baked = await bakeGeometries(
      layoutsFor(planned, options.layout),
      {
        ...baking,
        lines: lineMaker?.creases ?? false,
        onProgress: onProgress && ((progress) => onProgress((1 - mapShare) * progress)),
      },
      { onBaked: (geometry) => disposables.push(geometry), onCount: onGeometry },
    );
    const { looks, skipped } = asBefore(() => collectLooks(planned, baked));
    skipped.push(...unreadable);
    if (skipped.length > 0 && looks.length === 0) throw skipped[0].error;

    let map = isToBeMade(wanted) ? null : wanted;
    if (isDrawn && typeof wanted === 'function') map = checkTonalArtMap(await wanted());
    else if (isDrawn) {
      const onMapProgress = onProgress && ((progress: number) => onProgress(1 - mapShare + mapShare * progress));
      map = await TonalArtMap.generate({ ...wanted, signal, createWorker, onProgress: onMapProgress });
      disposables.push(map);
    }
    for (const material of withoutMap) material.tonalArtMap = map;
    signal?.throwIfAborted();
    const finishing = finish(root, looks, replacer, { strokeScale, lineMaker });
    if (lineMaker) disposables.push(lineMaker);
    const made = await runSliced(finishing, { signal });
    const gone = new Set(asBefore(() => planned.filter(hasChanged)).map(({ mesh }) => mesh));
    const kept = looks.filter(({ mesh }) => !gone.has(mesh));
    for (const { mesh } of looks) if (gone.has(mesh)) skipped.push({ mesh, error: changedMeanwhile(mesh) });
    if (kept.length === 0 && looks.length > 0) throw skipped.at(-1)!.error;
    const drawn = made.filter(({ mesh }) => !gone.has(mesh!));
    const used = new Set<Material>(kept.flatMap(({ material }) => material));
    const materials = replacer.materials.filter((material) => used.has(material));
    replaces?.dispose();
    releaseMeshes();
    releaseMeshes = claimMeshes(meshes);
    const scene = new HatchedScene(kept, materials, drawn, skipped, disposables, releaseMeshes);
    for (const { mesh } of kept) {
      for (const material of materialsOf(mesh)) if (isHatching(material)) material.announce(mesh);
    }
    return scene;
  } catch (error) {
    for (const disposable of disposables) disposable.dispose();
    releaseMeshes();
    throw error;
  } finally {
    options.signal?.removeEventListener('abort', onAbort);
  }
}

/** What the meshes look like that do not have a `HatchingMaterial` yet, and which of them have no geometry. */
function looksToReplace(meshes: readonly Mesh[]): { seen: OldLook[]; unreadable: SkippedMesh[] } {
  const seen: OldLook[] = [];
  const unreadable: SkippedMesh[] = [];
  for (const mesh of meshes) {
    if (materialsOf(mesh).every(isHatching)) continue;
    try {
      assertGeometry(mesh.geometry, 'applyHatching');
      seen.push({ mesh, geometry: mesh.geometry, oldMaterial: mesh.material });
    } catch (error) {
      unreadable.push({ mesh, error: error as Error });
    }
  }
  return { seen, unreadable };
}

/** What becomes of them. Yields after each: scenes have thousands of materials. */
function* planMeshes(looks: readonly OldLook[], replacer: MaterialReplacer): Generator<number, PlannedMesh[], void> {
  const planned: PlannedMesh[] = [];
  for (const look of looks) {
    const scale = worldScale(worldMatrices(look.mesh));
    planned.push({ ...look, material: replacer.replacementFor(look.mesh, look.oldMaterial, scale) });
    yield planned.length / looks.length;
  }
  return planned;
}

/** The options of its own and of its tasks; those of the geometry are checked where they are used. */
function checkOwnOptions(options: ApplyHatchingOptions): void {
  const { filter, lines = false, onGeometry, material = {}, replaces, strokeScale = 1, tonalArtMap = null } = options;
  if (replaces !== undefined && !(replaces instanceof HatchedScene)) {
    throw new TypeError('applyHatching: replaces must be what an earlier call resolved with, or left out.');
  }
  if (filter !== undefined && typeof filter !== 'function') {
    throw new TypeError('applyHatching: filter must be a function of a mesh, or left out.');
  }
  if (onGeometry !== undefined && typeof onGeometry !== 'function') {
    throw new TypeError('applyHatching: onGeometry must be a function of two numbers, or left out.');
  }
  if (typeof lines !== 'boolean' && (typeof lines !== 'object' || lines === null)) {
    throw new TypeError('applyHatching: lines must be true, false or an object of creases and parameters of lines.');
  }
  if (material === null || !['object', 'function'].includes(typeof material)) {
    throw new TypeError('applyHatching: material must be an object of parameters, or a function that returns one.');
  }
  if (!(strokeScale > 0 && strokeScale < Infinity)) {
    throw new RangeError(
      `applyHatching: strokeScale is ${strokeScale}, but must be a positive number of tiles per world unit, or left out.`,
    );
  }
  if (!isToBeMade(tonalArtMap)) checkTonalArtMap(tonalArtMap);
  else if (typeof tonalArtMap === 'object') checkHatchImageOptions('applyHatching: tonalArtMap', tonalArtMap);
}

/** Whether a map is to be drawn with these options, or fetched by this function, once a material needs it. */
const isToBeMade = (
  given: NonNullable<ApplyHatchingOptions['tonalArtMap']> | null,
): given is Exclude<typeof given, TonalArtMap | null> =>
  typeof given === 'function' || (typeof given === 'object' && given !== null && !isTonalArtMap(given));

/** Whether all that draws a mesh does without triangle adjacency. */
const needsNoAdjacency = (plan: PlannedMesh): boolean =>
  materialsOf(plan).every((one) => isHatching(one) && !needsAdjacency(one));

/** Every geometry to bake, with a layout that all materials that draw it can use. */
function layoutsFor(
  planned: readonly PlannedMesh[],
  layout: ApplyHatchingOptions['layout'],
): Map<BufferGeometry, ApplyHatchingOptions['layout']> {
  const layouts = new Map<BufferGeometry, ApplyHatchingOptions['layout']>();
  for (const plan of planned) {
    if (isBatched(plan.mesh)) continue;
    const known = layouts.get(plan.geometry) ?? 'indexed';
    layouts.set(plan.geometry, layout ?? (known === 'indexed' && needsNoAdjacency(plan) ? 'indexed' : 'auto'));
  }
  return layouts;
}

/** Divides the meshes into those that get a new look and those that stay as they are. */
function collectLooks(
  planned: readonly PlannedMesh[],
  baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>,
): { looks: MeshLook[]; skipped: SkippedMesh[] } {
  const looks: MeshLook[] = [];
  const skipped: SkippedMesh[] = [];
  for (const plan of planned) {
    const { mesh, material } = plan;
    const geometry = isBatched(mesh) ? batchGeometry(plan) : baked.get(plan.geometry)!;
    if (geometry instanceof Error) skipped.push({ mesh, error: geometry });
    else if (hasChanged(plan)) skipped.push({ mesh, error: changedMeanwhile(mesh) });
    else looks.push({ mesh, geometry, material, fieldFrame: undefined });
  }
  return { looks, skipped };
}

const hasChanged = ({ mesh, geometry, oldMaterial }: OldLook): boolean =>
  mesh.geometry !== geometry || mesh.material !== oldMaterial;

const changedMeanwhile = ({ name, uuid }: Mesh): Error =>
  new Error(
    `applyHatching: the mesh "${name || uuid}" was given another geometry or material while it was being baked. Restore, and apply again.`,
  );

/** The geometry of a BatchedMesh, or the reason why it cannot be hatched. */
function batchGeometry(plan: PlannedMesh): BufferGeometry | Error {
  const { mesh, geometry } = plan;
  if (needsNoAdjacency(plan) || geometry.hasAttribute(cornerLayout[0].name)) return geometry;
  return new TypeError(
    `applyHatching: the BatchedMesh "${mesh.name || mesh.uuid}" has no triangle adjacency. Use the technique 'anchored' for it, or fill it with the results of prepareHatchingGeometry().`,
  );
}

/**
 * Sizes the strokes, and gives every look its frame and its lines. Yields after each: scenes have thousands of meshes.
 *
 * @returns the lines, which are not in the scene yet
 */
function* finish(
  root: Object3D,
  looks: readonly MeshLook[],
  replacer: MaterialReplacer,
  { strokeScale, lineMaker }: { strokeScale: number | undefined; lineMaker: LineMaker | null },
): Generator<number, readonly HatchingLines[], void> {
  const { center, radius } = yield* sphereAround(looks);
  replacer.setStrokeScale(strokeScale ?? TILES_PER_RADIUS / radius);
  const fieldFrameOf = fieldFrames(root, center);
  for (const look of looks) {
    look.fieldFrame = fieldFrameOf(look.mesh);
    lineMaker?.addLines(look);
    yield 0;
  }
  return lineMaker?.lines ?? [];
}

/** A sphere around all meshes, world space; of radius 1 about the origin if there is none. */
function* sphereAround(looks: readonly MeshLook[]): Generator<number, Sphere, void> {
  const whole = new Sphere();
  for (const { mesh, geometry } of looks) {
    if (isBatched(mesh) && mesh.boundingSphere === null) mesh.computeBoundingSphere();
    const sphere = isBatched(mesh) ? mesh.boundingSphere! : geometry.boundingSphere!;
    for (const matrix of worldMatrices(mesh)) whole.union(sphere.clone().applyMatrix4(matrix));
    yield 0;
  }
  return whole.radius > 0 && Number.isFinite(whole.radius) ? whole : new Sphere(undefined, 1);
}
