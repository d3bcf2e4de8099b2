import { type BatchedMesh, type BufferGeometry, type Material, type Mesh, type Object3D, Sphere } from 'three';
import { cornerLayout } from '../bake/cornerLayout.js';
import type { PrepareHatchingGeometryOptions } from '../geometry/prepareHatchingGeometry.js';
import { TonalArtMap } from '../tam/TonalArtMap.js';
import { bakeGeometries } from './bakeGeometries.js';
import { claimMeshes } from './claimMeshes.js';
import { type Dress, HatchedScene, type SkippedMesh } from './HatchedScene.js';
import type { HatchingMaterialParameters } from './HatchingMaterialOptions.js';
import { isHatching, MaterialReplacer } from './MaterialReplacer.js';
import { surfaceMeshes } from './surfaceMeshes.js';
import { worldMatrices, worldScale } from './worldMatrices.js';

/** Options of `applyHatching`, beside those of `prepareHatchingGeometry`, which hold for every mesh. */
export interface ApplyHatchingOptions extends PrepareHatchingGeometryOptions {
  /**
   * For materials whose parameters name none. Without it one in the style `hatching` is generated, and disposed of. `null`:
   * none for now, all stays paper until you set one.
   */
  tonalArtMap?: TonalArtMap | null | undefined;
  /**
   * What the materials are to have beside what they take over; it wins. A function is called once for every material
   * made, with the one it replaces and the first mesh that wears it.
   */
  material?: HatchingMaterialParameters | ((source: Material, mesh: Mesh) => HatchingMaterialParameters) | undefined;
  /**
   * Size of the strokes: tiles of the map per unit of the world, the same on small and on large objects. The default is 3
   * over the radius of the whole. A `strokeScale` among the materials' parameters counts per unit of object space instead.
   */
  strokeScale?: number | undefined;
  /** Which meshes to hatch. Default: all. */
  filter?: ((mesh: Mesh) => boolean) | undefined;
}

/** A mesh as it is, and what it is to wear. */
interface Fitting extends Dress {
  mesh: Mesh;
  geometry: BufferGeometry;
  old: Material | Material[];
}

const TILES_PER_RADIUS = 3;
/** Part of the progress that goes to the map where one is generated. */
const MAP_SHARE = 0.2;

/**
 * Hatches a whole scene, such as a loaded glTF: bakes the geometry of every mesh at or below `root` (a shared one once)
 * and puts a `HatchingMaterial` in the place of every material, with its colour, maps, opacity, sides and vertex colours.
 * Instances, groups, skins and morph targets go on as before; lines, points and sprites are left alone. Nothing in the
 * scene changes before everything is ready, and nothing at all if that fails or is aborted.
 *
 * - A material shared by meshes becomes one shared material. Where the meshes differ in scale it becomes one for each
 *   scale, since `strokeScale` counts in object space; those that deform have one of their own.
 * - Meshes that have a `HatchingMaterial` of your own are left alone.
 * - A mesh whose geometry cannot be baked stays as it is and is listed in `skipped`; so is one that was given another
 *   geometry or material meanwhile.
 * - The layout, unless given, is `'indexed'` for geometries that only `anchored` draws.
 * - A `BatchedMesh` keeps its geometry. `anchored` hatches it by the normals it has; other techniques can only where it
 *   was filled with prepared geometries.
 *
 * Rejects if part of `root` is hatched already, with the signal's reason when aborted, with the first mesh's error if none
 * can be hatched, and when a map or a parameter cannot be had.
 */
export async function applyHatching(root: Object3D, options: ApplyHatchingOptions = {}): Promise<HatchedScene> {
  options.signal?.throwIfAborted();
  if (!root?.isObject3D) {
    throw new TypeError('applyHatching: expected a THREE.Object3D. For a loaded glTF pass gltf.scene.');
  }
  const meshes = surfaceMeshes(root).filter(options.filter ?? (() => true));
  const release = claimMeshes(meshes);
  const made: { dispose(): void }[] = [];
  try {
    root.updateWorldMatrix(true, false);
    root.updateMatrixWorld();
    const wardrobe = new MaterialReplacer(options.material ?? {});
    const fittings = meshes
      .filter(({ material }) => ![material].flat().every(isHatching))
      .map((mesh): Fitting => {
        const material = wardrobe.materialFor(mesh, worldScale(worldMatrices(mesh)));
        return { mesh, geometry: mesh.geometry, old: mesh.material, material };
      });
    made.push(...wardrobe.materials);

    const mapless = wardrobe.materials.filter(({ tonalArtMap }) => tonalArtMap === null);
    const mapShare = mapless.length > 0 && options.tonalArtMap === undefined ? MAP_SHARE : 0;
    const { onProgress, signal, createWorker } = options;
    const baked = await bakeGeometries(
      layoutsFor(fittings, options.layout),
      { ...options, onProgress: onProgress && ((progress) => onProgress((1 - mapShare) * progress)) },
      (geometry) => made.push(geometry),
    );
    const { dresses, skipped } = sortOut(fittings, baked);
    if (skipped.length > 0 && dresses.length === 0) throw skipped[0].error;

    let map = options.tonalArtMap ?? null;
    if (mapShare > 0) {
      const onMapProgress = onProgress && ((progress: number) => onProgress(1 - mapShare + mapShare * progress));
      map = await TonalArtMap.generate({ signal, createWorker, onProgress: onMapProgress });
      made.push(map);
    }
    for (const material of mapless) material.tonalArtMap = map;
    signal?.throwIfAborted();
    wardrobe.sizeStrokes(options.strokeScale ?? TILES_PER_RADIUS / radiusOf(dresses));
    const worn = new Set<Material>(dresses.flatMap(({ material }) => material));
    const materials = wardrobe.materials.filter((material) => worn.has(material));
    return new HatchedScene(dresses, materials, skipped, made, release);
  } catch (error) {
    for (const thing of made) thing.dispose();
    release();
    throw error;
  }
}

const isBatched = (mesh: Mesh): mesh is BatchedMesh => 'isBatchedMesh' in mesh;

const isAnchored = ({ material }: Dress): boolean =>
  [material].flat().every((one) => isHatching(one) && one.technique === 'anchored');

/** Every geometry to be baked, with the layout that all that draw it can do with. */
function layoutsFor(
  fittings: readonly Fitting[],
  layout: ApplyHatchingOptions['layout'],
): Map<BufferGeometry, ApplyHatchingOptions['layout']> {
  const layouts = new Map<BufferGeometry, ApplyHatchingOptions['layout']>();
  for (const fitting of fittings) {
    if (isBatched(fitting.mesh)) continue;
    const known = layouts.get(fitting.geometry) ?? 'indexed';
    layouts.set(fitting.geometry, layout ?? (known === 'indexed' && isAnchored(fitting) ? 'indexed' : 'auto'));
  }
  return layouts;
}

/** Tells the meshes that can be dressed from those that stay as they are. */
function sortOut(
  fittings: readonly Fitting[],
  baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>,
): { dresses: Dress[]; skipped: SkippedMesh[] } {
  const dresses: Dress[] = [];
  const skipped: SkippedMesh[] = [];
  for (const fitting of fittings) {
    const { mesh, material } = fitting;
    const geometry = isBatched(mesh) ? batchGeometry(fitting) : baked.get(fitting.geometry)!;
    const hasChanged = mesh.geometry !== fitting.geometry || mesh.material !== fitting.old;
    if (geometry instanceof Error) skipped.push({ mesh, error: geometry });
    else if (hasChanged) skipped.push({ mesh, error: changedMeanwhile(mesh) });
    else dresses.push({ mesh, geometry, material });
  }
  return { dresses, skipped };
}

const changedMeanwhile = ({ name, uuid }: Mesh): Error =>
  new Error(
    `applyHatching: the mesh "${name || uuid}" was given another geometry or material while it was being baked. Restore, and apply again.`,
  );

function batchGeometry(fitting: Fitting): BufferGeometry | Error {
  const { mesh, geometry } = fitting;
  if (isAnchored(fitting) || geometry.hasAttribute(cornerLayout[0].name)) return geometry;
  return new TypeError(
    `applyHatching: the BatchedMesh "${mesh.name || mesh.uuid}" has no triangle adjacency. Use the technique 'anchored' for it, or fill it with the results of prepareHatchingGeometry().`,
  );
}

/** Radius of a sphere around all meshes as they stand in the world; 1 where there is none. */
function radiusOf(dresses: readonly Dress[]): number {
  const whole = new Sphere();
  for (const { mesh, geometry } of dresses) {
    if (isBatched(mesh) && mesh.boundingSphere === null) mesh.computeBoundingSphere();
    const sphere = isBatched(mesh) ? mesh.boundingSphere! : geometry.boundingSphere!;
    for (const matrix of worldMatrices(mesh)) whole.union(sphere.clone().applyMatrix4(matrix));
  }
  return whole.radius > 0 && Number.isFinite(whole.radius) ? whole.radius : 1;
}
