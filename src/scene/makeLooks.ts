/** The code that makes materials, geometries and maps. It is fetched when a scene is hatched; pages need nothing of it before. */
import type { BufferGeometry, Material, Texture } from 'three';
import { needsMap } from '../look/queries.js';
import type { PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import { runSliced } from '../mesh/runSliced.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import { isToBeMade, prepareOptions } from './applyOptions.js';
import { bakeGeometries, progressParts, stoppedWith } from './bakeGeometries.js';
import { type ChosenMeshes, failure } from './chooseMeshes.js';
import { type GeometryPlan, geometryPlans, type OldLook, type PlannedMesh } from './geometryPlans.js';
import type { HatchedScene, SkippedMesh } from './HatchedScene.js';
import type { HatchingCall, OldLooks } from './HatchingCall.js';
import type { LaterForms } from './LaterForms.js';
import { MaterialReplacer } from './MaterialReplacer.js';
import { makeMaps } from './makeMaps.js';
import { worldMatrices, worldScale } from './worldMatrices.js';

/** The shares of the progress for parts that only some calls make. The bake has the rest. */
const SHARES = { map: 0.2, frame: 0.1, detail: 0.2 };

/** The new materials of meshes, and the geometries to bake. */
interface Plans {
  replacer: MaterialReplacer;
  planned: readonly PlannedMesh[];
  plans: Map<BufferGeometry, GeometryPlan>;
  /** Bakes fields later, if lines follow the form anywhere. */
  forms: LaterForms | null;
}

/** Makes the new looks of meshes without changing the scene. @returns the function that shows them */
export async function makeLooks(call: HatchingCall, old: OldLooks, choice: ChosenMeshes): Promise<() => HatchedScene> {
  const { options, makers, firstFrame, outlineMaker, disposables } = call;
  const { signal, onGeometry, onProgress } = options;
  const prepare = { ...prepareOptions(options), outlines: outlineMaker?.creases ?? false };
  const { replacer, planned, plans, forms } = await planLooks(call, old, prepare);

  const named = replacer.materials.filter((material) => typeof material.tonalArtMap === 'string' && needsMap(material));
  const styles = [...new Set(named.map(({ tonalArtMap }) => tonalArtMap as StrokeStyleName))];
  const isMapMade = styles.length > 0 && (options.tonalArtMap === undefined || isToBeMade(options.tonalArtMap));
  const parts = [isMapMade && SHARES.map, firstFrame && SHARES.frame, call.detail && SHARES.detail].map(Number);
  const bakeShare = 1 - parts.reduce((sum, share) => sum + share);
  const [onBake, onMap, onFrame, onDetail] = progressParts(onProgress, [bakeShare, ...parts]);
  // The code that dresses looks is fetched while geometries are baked.
  const [baked, maps, { dressLooks }] = await sideBySide(
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
        import('./dressLooks.js'),
        ...replacer.materials.map((material) => makers.fetchPartsOf(material)),
      ]);
      call.asBefore(() => firstFrame?.compile(planned, outlineMaker?.samples ?? [], false));
      return dressing;
    },
  );
  forms?.drawMeanwhile(baked);
  for (const material of named) material.tonalArtMap = maps.get(material.tonalArtMap as StrokeStyleName) ?? null;
  return dressLooks(call, { choice, unreadable: old.unreadable, replacer, planned, baked, forms }, onFrame, onDetail);
}

/**
 * Makes the materials of meshes, and plans their bakes, in groups if lines follow the form. Without such lines the code that bakes
 * fields later is not loaded.
 */
async function planLooks(
  { options, makers, disposables, asBefore, firstFrame, detail }: HatchingCall,
  { seen, unreadable }: OldLooks,
  prepare: PrepareHatchingGeometryOptions,
): Promise<Plans> {
  const { signal } = options;
  const replacer = new MaterialReplacer(options.material ?? {}, makers.material);
  disposables.push(replacer);
  const displaced = await displaceMeshes(seen, unreadable);
  const planned = await runSliced(planMeshes(displaced, replacer), { signal, around: asBefore });
  const plans = geometryPlans(planned, options);
  if ([...plans.values()].every(({ form }) => !form)) return { replacer, planned, plans, forms: null };
  const [{ crossingMaterials, LaterForms }, { formGroups }] = await Promise.all([
    import('./LaterForms.js'),
    import('./jointForms.js'),
  ]);
  const groups = await runSliced(formGroups(planned, plans), { signal });
  for (const [geometry, plan] of plans) plan.group = groups.get(geometry);
  const crossing = crossingMaterials(planned, options);
  const forms = new LaterForms(plans, crossing, prepare, { ...options, disposables, firstFrame, detail });
  return { replacer, planned, plans, forms };
}

/**
 * Runs jobs concurrently, and resolves with their results. If one fails, the others are aborted, and once all have ended the promise is
 * rejected with the first error.
 *
 * @param signal aborts all jobs
 * @param jobs are started in this order, each with a signal that aborts it
 */
async function sideBySide<Results extends unknown[]>(
  signal: AbortSignal | undefined,
  ...jobs: { [Index in keyof Results]: (signal: AbortSignal) => Promise<Results[Index]> }
): Promise<Results> {
  const { stop, unlink } = stoppedWith(signal);
  try {
    const running = jobs.map((job) =>
      job(stop.signal).catch((error: unknown) => {
        // Only the first reason counts; later calls of abort() have no effect.
        stop.abort(error);
      }),
    );
    const results = await Promise.all(running);
    stop.signal.throwIfAborted();
    return results as Results;
  } finally {
    unlink();
  }
}

/** Makes the new materials of meshes. It yields after each mesh, since a scene may have thousands of materials. */
function* planMeshes(looks: readonly OldLook[], replacer: MaterialReplacer): Generator<number, PlannedMesh[], void> {
  const planned: PlannedMesh[] = [];
  for (const look of looks) {
    const scale = worldScale(worldMatrices(look.mesh));
    planned.push({ ...look, material: replacer.replacementFor(look.mesh, look.oldMaterial, scale) });
    yield planned.length / looks.length;
  }
  return planned;
}

/**
 * Sets a displaced geometry, to be baked, on looks whose materials have a displacement map. Scenes without such materials do not load
 * the code for it.
 *
 * @param unreadable receives the meshes that cannot be displaced
 */
async function displaceMeshes(looks: readonly OldLook[], unreadable: SkippedMesh[]): Promise<readonly OldLook[]> {
  if (!looks.some(isDisplaced)) return looks;
  const { Displacer } = await import('./Displacer.js');
  const displacer = new Displacer();
  return looks.flatMap((look) => {
    if (!isDisplaced(look)) return [look];
    try {
      return [{ ...look, geometry: displacer.displaced(look), flatGeometry: look.geometry }];
    } catch (error) {
      unreadable.push(failure(look.mesh, error as Error));
      return [];
    }
  });
}

const isDisplaced = ({ oldMaterial }: OldLook): boolean =>
  [oldMaterial].flat().some((material: Displaceable | null | undefined) => material?.displacementMap);

type Displaceable = Material & { displacementMap?: Texture | null };
