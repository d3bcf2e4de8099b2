/** All that hatches a scene. It is fetched when a scene is hatched; pages need nothing of it before. */
import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute, Material, Texture } from 'three';
import { needsMap } from '../look/queries.js';
import { isFormExpected } from '../material/geometry/formGeometry.js';
import type { PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { TonalArtMap } from '../material/tam/TonalArtMap.js';
import { runSliced } from '../mesh/runSliced.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { isToBeMade, prepareOptions } from './applyOptions.js';
import { bakeGeometries, progressParts, stoppedWith } from './bakeGeometries.js';
import { failure } from './chooseMeshes.js';
import { dressLooks } from './dressLooks.js';
import { type FormGroup, type GeometryPlan, geometryPlans, type OldLook, type PlannedMesh } from './geometryPlans.js';
import type { BakedGeometry, HatchingCall, MadeLooks, OldLooks } from './HatchingCall.js';
import { formGroups } from './jointForms.js';
import { crossingMaterials, LaterForms } from './LaterForms.js';
import { MaterialReplacer } from './MaterialReplacer.js';
import { makeMaps } from './makeMaps.js';
import type { SkippedMesh } from './SkippedMesh.js';
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

/** Makes the new looks of meshes without changing the scene. */
export async function makeLooks(call: HatchingCall, old: OldLooks): Promise<MadeLooks> {
  const { options, makers, style, firstFrame, outlineMaker, disposables } = call;
  const { signal, onGeometry, onProgress } = options;
  const prepare = { ...prepareOptions(options), outlines: outlineMaker?.creases ?? false };
  const geometries = new Set<BufferGeometry>();
  disposables.push({ dispose: () => disposeAll(geometries) });
  const { replacer, planned, plans, forms } = await planLooks(call, old, prepare, geometries);

  const named = replacer.added.filter(({ material }) => typeof material.tonalArtMap === 'string' && needsMap(material));
  const styles = [...new Set(named.map(({ material }) => material.tonalArtMap as StrokeStyleName))];
  const missing = styles.filter((one) => !style.maps.has(one));
  const isMapMade = missing.length > 0 && (options.tonalArtMap === undefined || isToBeMade(options.tonalArtMap));
  const parts = [isMapMade && SHARES.map, firstFrame && SHARES.frame, call.detail && SHARES.detail].map(Number);
  const bakeShare = 1 - parts.reduce((sum, share) => sum + share);
  const [onBake, onMap, onFrame, onDetail] = progressParts(onProgress, [bakeShare, ...parts]);
  const { reused, rest } = reusableOf(plans, forms?.atOnce ?? plans, call, prepare);
  const [fresh, maps] = await sideBySide(
    signal,
    (stop) =>
      bakeGeometries(
        rest,
        { ...prepare, onProgress: onBake, signal: stop },
        { onBaked: (geometry) => geometries.add(geometry), onCount: onGeometry },
      ),
    (stop) => mapsFor(call, missing, { ...options, onProgress: onMap, signal: stop }),
    async () => {
      await Promise.all(replacer.materials.map((material) => makers.fetchPartsOf(material)));
      call.asBefore(() => firstFrame?.compile(planned, outlineMaker?.samples ?? [], false));
    },
  );
  const baked = new Map([...reused, ...fresh]);
  forms?.drawMeanwhile(baked);
  for (const one of named) one.give('tonalArtMap', maps.get(one.material.tonalArtMap as StrokeStyleName) ?? null);
  const made = { unreadable: old.unreadable, replacer, planned, baked, forms };
  const dressed = await dressLooks(call, made, onFrame, onDetail);
  return { ...dressed, maps, geometries, forms, baked: bakesToKeep(baked, forms?.atOnce ?? plans, call, prepare) };
}

function disposeAll(geometries: Set<BufferGeometry>): void {
  for (const geometry of geometries) geometry.dispose();
  geometries.clear();
}

/** The map of each style: those of the look, and those that it misses. All are the same if an option says which map to take. */
async function mapsFor(
  { options: { tonalArtMap }, style, madeMaps }: HatchingCall,
  missing: readonly StrokeStyleName[],
  options: TaskOptions,
): Promise<ReadonlyMap<StrokeStyleName, TonalArtMap | null>> {
  const [known] = style.maps.values();
  const made =
    tonalArtMap !== undefined && known !== undefined
      ? new Map(missing.map((name) => [name, known]))
      : await makeMaps(tonalArtMap, missing, options, madeMaps);
  return new Map([...style.maps, ...made]);
}

const versionOf = (attribute: BufferAttribute | InterleavedBufferAttribute): number =>
  'data' in attribute ? attribute.data.version : attribute.version;

/** The names of groups: one text for all members, since that of a thousand parts is long. */
const groupKeys = new WeakMap<FormGroup, string>();

/** Names the parts of a group, their places and the versions of their positions. */
function groupKeyOf(group: FormGroup): string {
  const known = groupKeys.get(group);
  if (known !== undefined) return known;
  const parts = group.parts.map(({ geometry, matrix }) => [
    geometry.uuid,
    versionOf(geometry.attributes.position),
    matrix.elements,
  ]);
  const key = JSON.stringify(parts);
  groupKeys.set(group, key);
  return key;
}

/** Names the bake of a geometry, without its group: bakes of one name and one group have the same result. */
function bakeKey(
  { index, attributes, morphAttributes, groups }: BufferGeometry,
  { layout, form }: GeometryPlan,
  { adjacency, creaseAngle, smoothingRadius, weldTolerance, outlines }: PrepareHatchingGeometryOptions,
): string {
  const versions = Object.entries(attributes).map(([name, attribute]) => [name, versionOf(attribute)]);
  const morphs = Object.entries(morphAttributes).map(([name, all]) => [name, all.map(versionOf)]);
  const options = { adjacency, creaseAngle, smoothingRadius, weldTolerance, outlines };
  return JSON.stringify([layout, options, form, index && versionOf(index), versions, morphs, groups]);
}

/** Names the group that a geometry is baked in; undefined if it is baked alone. */
const groupKeyIn = ({ group }: GeometryPlan): string | undefined => group && groupKeyOf(group);

/** Divides geometries to bake into those whose baked geometry exists already, and the rest. */
function reusableOf(
  plans: ReadonlyMap<BufferGeometry, GeometryPlan>,
  atOnce: ReadonlyMap<BufferGeometry, GeometryPlan>,
  { reusable, detail }: HatchingCall,
  prepare: PrepareHatchingGeometryOptions,
): { reused: Map<BufferGeometry, BufferGeometry>; rest: ReadonlyMap<BufferGeometry, GeometryPlan> } {
  const reused = new Map<BufferGeometry, BufferGeometry>();
  const rest = new Map(atOnce);
  // Levels of detail change the index of a geometry.
  if (detail) return { reused, rest };
  for (const [source, plan] of atOnce) {
    const known = reusable.get(source);
    if (!known || known.positions !== source.attributes.position) continue;
    // A form that is baked later may be there already.
    const isThat = (one: GeometryPlan): boolean =>
      known.groupKey === groupKeyIn(one) && known.key === bakeKey(source, one, prepare);
    if (!isThat(plan) && !isThat(plans.get(source)!)) continue;
    reused.set(source, known.geometry);
    rest.delete(source);
  }
  return { reused, rest };
}

/** The baked geometries that later calls may use, too. */
function bakesToKeep(
  baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>,
  plans: ReadonlyMap<BufferGeometry, GeometryPlan>,
  { detail }: HatchingCall,
  prepare: PrepareHatchingGeometryOptions,
): Map<BufferGeometry, BakedGeometry> {
  const kept = new Map<BufferGeometry, BakedGeometry>();
  if (detail) return kept;
  for (const [source, geometry] of baked) {
    if (geometry instanceof Error || isFormExpected(geometry)) continue;
    const positions = source.attributes.position as BufferAttribute;
    const plan = plans.get(source)!;
    kept.set(source, { geometry, key: bakeKey(source, plan, prepare), groupKey: groupKeyIn(plan), positions });
  }
  return kept;
}

/**
 * Makes the materials of meshes, and plans their bakes, in groups if lines follow the form.
 */
async function planLooks(
  call: HatchingCall,
  { seen, unreadable }: OldLooks,
  prepare: PrepareHatchingGeometryOptions,
  geometries: Set<BufferGeometry>,
): Promise<Plans> {
  const { options, makers, style, disposables, asBefore, firstFrame, detail } = call;
  const { signal } = options;
  const replacer = new MaterialReplacer(options.material ?? {}, makers.material, style.replacements, style.composition);
  disposables.push(replacer);
  const displaced = await displaceMeshes(seen, unreadable);
  const planned = await runSliced(planMeshes(displaced, replacer), { signal, around: asBefore });
  call.takeEdits(replacer.added);
  const plans = geometryPlans(planned, options);
  if ([...plans.values()].every(({ form }) => !form)) return { replacer, planned, plans, forms: null };
  const groups = await runSliced(formGroups(planned, plans), { signal });
  for (const [geometry, plan] of plans) plan.group = groups.get(geometry);
  const crossing = crossingMaterials(planned, options);
  const onFormed = (source: BufferGeometry, geometry: BufferGeometry, plan: GeometryPlan): void => {
    const formed = new Map([[source, geometry]]);
    for (const [, one] of bakesToKeep(formed, new Map([[source, plan]]), call, prepare)) call.reusable.set(source, one);
  };
  const forms = new LaterForms(plans, crossing, prepare, { ...options, geometries, firstFrame, detail, onFormed });
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
