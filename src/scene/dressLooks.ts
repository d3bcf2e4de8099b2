import { Box3, type BufferGeometry, Matrix4, type Mesh, type Object3D, Sphere, type Vector3 } from 'three';
import { describeObject } from '../material/diagnostics/describeObject.js';
import { SceneExtent } from '../material/fading/SceneExtent.js';
import { cornerLayout } from '../mesh/bake/attributeLayouts.js';
import { runSliced } from '../mesh/runSliced.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { failure, sentencesOf } from './chooseMeshes.js';
import { type MeshLook, needsNoAdjacency, type OldLook, type PlannedMesh } from './geometryPlans.js';
import type { HatchingCall, MadeLooks, SceneMeasures } from './HatchingCall.js';
import type { LaterForms } from './LaterForms.js';
import type { MaterialReplacer } from './MaterialReplacer.js';
import type { SkippedMesh } from './SkippedMesh.js';
import { isBatched } from './surfaceMeshes.js';
import { worldMatrices, worldScale } from './worldMatrices.js';

/** Applies the new looks to meshes after the bake. */

/** What was planned and made for a call. */
interface Made {
  unreadable: readonly SkippedMesh[];
  replacer: MaterialReplacer;
  planned: readonly PlannedMesh[];
  baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>;
  forms: LaterForms | null;
}

type DressedLooks = Pick<MadeLooks, 'looks' | 'replacements' | 'measures' | 'failed' | 'showDetail'>;
type OnProgress = ((progress: number) => void) | undefined;

/** Gives looks their sizes, frames of lines, outlines, levels of detail and programs. */
export async function dressLooks(
  call: HatchingCall,
  { unreadable, replacer, planned, baked }: Made,
  onFrame: OnProgress,
  onDetail: OnProgress,
): Promise<DressedLooks> {
  const { options, firstFrame, outlineMaker, detail, asBefore, mustHatch } = call;
  const { signal } = options;
  const { looks, failed } = asBefore(() => collectLooks(planned, baked));
  failed.push(...unreadable);
  if (looks.length === 0 && mustHatch) assertNoFailure(failed);
  signal?.throwIfAborted();
  const measures = await runSliced(finishLooks(call, looks, replacer), { signal });
  const outlines = outlineMaker?.outlines ?? [];
  const showDetail = await detail?.(looks, onDetail);
  if (firstFrame) {
    firstFrame.compile(looks, outlines, true);
    await runSliced(firstFrame.upload(looks), { signal, onProgress: onFrame });
    await firstFrame.built(signal);
    onFrame?.(1);
  }

  const changed = new Set(asBefore(() => planned.filter(hasChanged)).map(({ mesh }) => mesh));
  const kept = looks.filter(({ mesh }) => !changed.has(mesh));
  for (const { mesh } of looks) if (changed.has(mesh)) failed.push(changedMeanwhile(mesh));
  if (kept.length === 0 && mustHatch) assertNoFailure(failed);
  return { looks: kept, replacements: replacer.used, measures, failed, showDetail };
}

/** The default stroke scale: tiles of the map per radius of the scene. */
const TILES_PER_RADIUS = 3;

/** Divides the meshes into those that get a new look and those that are skipped. */
function collectLooks(
  planned: readonly PlannedMesh[],
  baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>,
): { looks: MeshLook[]; failed: SkippedMesh[] } {
  const looks: MeshLook[] = [];
  const failed: SkippedMesh[] = [];
  for (const plan of planned) {
    const { mesh, material } = plan;
    const geometry = isBatched(mesh) ? batchGeometry(plan) : baked.get(plan.geometry)!;
    if (geometry instanceof Error) failed.push(failure(mesh, geometry));
    else if (hasChanged(plan)) failed.push(changedMeanwhile(mesh));
    else looks.push({ mesh, geometry, material, fieldFrame: undefined });
  }
  return { looks, failed };
}

/** Whether another geometry or material was set on a mesh since. */
const hasChanged = ({ mesh, geometry, flatGeometry = geometry, oldMaterial }: OldLook): boolean =>
  mesh.geometry !== flatGeometry || mesh.material !== oldMaterial;

/** The mesh as a skipped one, with that reason. */
const changedMeanwhile = (mesh: Mesh): SkippedMesh =>
  failure(
    mesh,
    new Error(
      'applyHatching: it was given another geometry or material while it was being baked. Call update() of the result.',
    ),
  );

/** The geometry of a BatchedMesh, or the reason why it cannot be hatched. */
function batchGeometry(plan: PlannedMesh): BufferGeometry | Error {
  const { mesh, geometry } = plan;
  if (needsNoAdjacency(plan) || geometry.hasAttribute(cornerLayout[0].name)) return geometry;
  return new TypeError(
    `applyHatching: the ${describeObject(mesh)} has no triangle adjacency. Use the technique 'hatching' for it, or fill it with results of prepareHatchingGeometry(geometry, { adjacency: true }).`,
  );
}

/**
 * Sets the size of the strokes, and gives every look its coordinate frame and its outlines. It yields after each look, since a scene
 * may have thousands of meshes.
 *
 * @returns the measures of the scene: those of its look, or new ones
 */
function* finishLooks(
  { root, choice, style, outlineMaker, options, isDetached, fieldFrameOf }: HatchingCall,
  looks: readonly MeshLook[],
  replacer: MaterialReplacer,
): Generator<number, SceneMeasures, void> {
  const attached = looks.filter(({ mesh }) => !isDetached(mesh));
  const measures = style.measures ?? (yield* measuresOf(root, attached, choice.claimed, options));
  replacer.setTilesPerUnit(measures.tilesPerWorldUnit);
  const frameOf = fieldFrames(root, measures.center);
  for (const look of looks) {
    look.fieldFrame = isDetached(look.mesh) ? fieldFrameOf(look.mesh) : frameOf(look.mesh);
    outlineMaker?.addOutlines(look);
    yield 0;
  }
  return measures;
}

/** Measures a scene. Meshes that others have hatched count, so that strokes of all have one size. */
function* measuresOf(
  root: Object3D,
  looks: readonly MeshLook[],
  claimed: readonly Mesh[],
  { tilesPerWorldUnit }: ApplyHatchingOptions,
): Generator<number, SceneMeasures, void> {
  const hatchedBefore = claimed.filter((mesh) => isBatched(mesh) || mesh.geometry.boundingSphere !== null);
  const { center, radius } = yield* sphereAround([...looks, ...hatchedBefore]);
  const extent = new SceneExtent(root);
  for (const look of [...looks, ...hatchedBefore]) {
    growExtent(extent, look);
    yield 0;
  }
  return { tilesPerWorldUnit: tilesPerWorldUnit ?? TILES_PER_RADIUS / radius, center, extent };
}

/** A sphere around all meshes in world space; without meshes the unit sphere. */
function* sphereAround(looks: readonly (MeshLook | Mesh)[]): Generator<number, Sphere, void> {
  const whole = new Sphere();
  for (const look of looks) {
    const { mesh, geometry } = 'isMesh' in look ? { mesh: look, geometry: look.geometry } : look;
    if (isBatched(mesh) && mesh.boundingSphere === null) mesh.computeBoundingSphere();
    const sphere = isBatched(mesh) ? mesh.boundingSphere! : geometry.boundingSphere!;
    for (const matrix of worldMatrices(mesh)) whole.union(sphere.clone().applyMatrix4(matrix));
    yield 0;
  }
  return whole.radius > 0 && Number.isFinite(whole.radius) ? whole : new Sphere(undefined, 1);
}
/** @throws TypeError that names the first meshes that could not be hatched */
function assertNoFailure(skipped: readonly SkippedMesh[]): void {
  if (skipped.length === 0) return;
  throw new TypeError(`applyHatching: no mesh could be hatched. ${sentencesOf(skipped)}`, { cause: skipped[0].error });
}

/** Makes the extent of a scene include a mesh. */
export function growExtent(extent: SceneExtent, look: MeshLook | Mesh): void {
  const { mesh, geometry } = 'isMesh' in look ? { mesh: look, geometry: look.geometry } : look;
  const toRoot = extent.frame.matrixWorld.clone().invert();
  const bounds = boundsOf(mesh, geometry);
  for (const matrix of worldMatrices(mesh))
    extent.box.union(bounds.clone().applyMatrix4(matrix.clone().premultiply(toRoot)));
}

function boundsOf(mesh: Mesh, { boundingBox, boundingSphere }: Mesh['geometry']): Box3 {
  if (isBatched(mesh)) return mesh.boundingSphere!.getBoundingBox(new Box3());
  return boundingBox ?? boundingSphere!.getBoundingBox(new Box3());
}

/**
 * Returns a function that computes the matrix from the object space of a mesh to the coordinate frame that all meshes share: the frame
 * of `root`, with its origin in a common centre. Engraved lines in this frame continue from mesh to mesh. Its unit is that of the
 * mesh's object space, because `tilesPerObjectUnit` refers to that. Instanced and batched meshes, and meshes with a singular matrix, have no
 * such frame.
 *
 * @param centre the centre of all meshes, in world space
 */
function fieldFrames(root: Object3D, centre: Vector3): (mesh: Mesh) => number[] | undefined {
  const rootScale = worldScale([root.matrixWorld]);
  const worldToRoot = root.matrixWorld.clone().invert();
  const origin = centre.clone().applyMatrix4(worldToRoot);
  const isRootFlat = root.matrixWorld.determinant() === 0;
  return (mesh) => {
    if (isRootFlat || 'isInstancedMesh' in mesh || isBatched(mesh)) return undefined;
    const matrices = worldMatrices(mesh);
    if (matrices[0].determinant() === 0) return undefined;
    const scale = rootScale / worldScale(matrices);
    return new Matrix4()
      .makeScale(scale, scale, scale)
      .multiply(new Matrix4().makeTranslation(-origin.x, -origin.y, -origin.z))
      .multiply(worldToRoot)
      .multiply(matrices[0])
      .toArray();
  };
}
