import type { BufferAttribute, BufferGeometry } from 'three';
import { isFormed } from '../material/geometry/formGeometry.js';
import { fadeIn, fadeOut, showLines } from '../material/geometry/lineFades.js';
import type { PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import { hatchNormal } from '../mesh/bake/attributeLayouts.js';
import { runSliced } from '../mesh/runSliced.js';
import { bakeGeometries } from './bakeGeometries.js';
import type { FirstFrame } from './FirstFrame.js';
import { cornerCount, type GeometryPlan, type MeshLook } from './geometryPlans.js';
import type { HideDetail, MakeLevels } from './levelMaker.js';
import { isSame } from './meshLooks.js';

/** What bakes share with the call of `applyHatching`, which documents the listeners. */
export interface FormCall {
  onFormProgress?: ((progress: number) => void) | undefined;
  invalidate?: (() => void) | undefined;
  /** The geometries that were made: those in use, and none else. */
  geometries: Set<BufferGeometry>;
  firstFrame: FirstFrame | null;
  detail: MakeLevels | null;
  /** Called when meshes draw with a geometry that was baked later. */
  onFormed(source: BufferGeometry, geometry: BufferGeometry, plan: GeometryPlan): void;
}

/** A source geometry whose lines follow the form, or will. */
export interface Field {
  source: BufferGeometry;
  /** How its field is to be baked: with the angle that its material asks for. */
  plan: GeometryPlan;
  /** The prepared geometry in use. */
  drawn: BufferGeometry;
  /** Whether the field of `drawn` is missing, or has another angle. */
  isAwaited: boolean;
  /** Ends the drawing of levels of detail, if there are any. */
  hideDetail?: HideDetail | undefined;
}

/** The fields of a scene, and the meshes that they are drawn on. */
export interface FormState {
  readonly fields: readonly Field[];
  readonly looks: readonly MeshLook[];
  /** The looks that were given another geometry. */
  readonly changed: Set<MeshLook>;
  readonly prepare: PrepareHatchingGeometryOptions;
  readonly call: FormCall;
  /** Watches the angle between crossing lines of a geometry with a field. */
  watch(field: Field): void;
}

/**
 * Bakes fields, and draws with them when all are ready.
 *
 * @param sayFailed is called for each field that cannot be baked
 */
export async function changeForms(
  forms: FormState,
  fields: readonly Field[],
  signal: AbortSignal,
  sayFailed: (error: Error) => void,
): Promise<void> {
  const { prepare, call } = forms;
  const made = new Set<BufferGeometry>();
  try {
    const plans = new Map(fields.map(({ source, plan }) => [source, plan]));
    const options = { ...prepare, onProgress: call.onFormProgress, signal };
    const baked = await bakeGeometries(plans, options, { onBaked: (geometry) => made.add(geometry) });
    const next = new Map<Field, BufferGeometry>();
    for (const field of fields) {
      const to = baked.get(field.source)!;
      // A field that cannot be baked is not tried again.
      if (to instanceof Error) {
        sayFailed(to);
        field.isAwaited = false;
      } else if (isFormed(to)) next.set(field, to);
    }
    if (next.size === 0) return;
    for (const [{ drawn }, to] of next) copyOcclusion(drawn, to);
    const looks = forms.looks.flatMap((look) => {
      const field = fields.find(({ drawn }) => drawn === look.geometry);
      const geometry = field && next.get(field);
      return geometry ? [{ ...look, geometry }] : [];
    });
    const showDetail = await makeDetail(call, looks, signal);
    await prepareFrame(call, looks, signal);
    await changeOver(forms, next, signal, showDetail);
  } finally {
    // Those in use are freed with the rest of the call.
    for (const geometry of made) if (!call.geometries.has(geometry)) geometry.dispose();
  }
}

/** Makes levels of detail of geometries, if they are requested. Each gets the levels of the geometry that it replaces. */
async function makeDetail(
  { detail }: FormCall,
  looks: readonly MeshLook[],
  signal: AbortSignal,
): Promise<ReadonlyMap<BufferGeometry, () => HideDetail>> {
  const details = new Map<BufferGeometry, () => HideDetail>();
  if (!detail) return details;
  for (const geometry of new Set(looks.map((look) => look.geometry))) {
    const its = looks.filter((look) => look.geometry === geometry);
    details.set(geometry, await detail(its));
    signal.throwIfAborted();
  }
  return details;
}

/** Compiles programs and uploads geometries before they are drawn, so that no frame waits for it. */
async function prepareFrame({ firstFrame }: FormCall, looks: readonly MeshLook[], signal: AbortSignal): Promise<void> {
  if (!firstFrame) return;
  firstFrame.compile(looks, [], true);
  await runSliced(firstFrame.upload(looks), { signal });
  await firstFrame.built(signal);
}

/**
 * Changes to other geometries. Lines along the light fade into an even grey of their tone, and lines along the form fade in from it.
 */
async function changeOver(
  forms: FormState,
  next: ReadonlyMap<Field, BufferGeometry>,
  signal: AbortSignal,
  showDetail: ReadonlyMap<BufferGeometry, () => HideDetail>,
): Promise<void> {
  const { invalidate = () => {} } = forms.call;
  const fading = [...next].filter(([{ drawn }]) => !isFormed(drawn));
  const before = fading.map(([{ drawn }]) => drawn);
  await fadeOut(before, signal, invalidate);
  showLines(before);
  signal.throwIfAborted();
  for (const [field, to] of next) {
    // The meshes may have been released in the meantime.
    if (!forms.fields.includes(field)) continue;
    exchange(forms, field.drawn, to);
    field.hideDetail?.();
    field.hideDetail = showDetail.get(to)?.();
    field.drawn = to;
    field.isAwaited = false;
    forms.call.onFormed(field.source, to, field.plan);
    forms.watch(field);
  }
  await fadeIn(
    fading.map(([, to]) => to),
    signal,
    invalidate,
  );
  invalidate();
}

/** Replaces a geometry on all meshes that still have it. */
function exchange({ looks, changed, call }: FormState, from: BufferGeometry, to: BufferGeometry): void {
  for (const look of looks) {
    if (look.geometry !== from) continue;
    look.geometry = to;
    if (isSame(look.mesh.geometry, from)) look.mesh.geometry = to;
    changed.add(look);
  }
  const { geometries } = call;
  geometries.delete(from);
  geometries.add(to);
  from.dispose();
}

/** Copies the occlusion that `bakeOcclusion` has written in the meantime. The corners of both geometries are the same. */
function copyOcclusion(from: BufferGeometry, to: BufferGeometry): void {
  const { array: source } = from.attributes[hatchNormal.name] as BufferAttribute;
  const { array: target } = to.attributes[hatchNormal.name] as BufferAttribute;
  const vertices = from.index?.array;
  const newVertices = to.index?.array;
  // The methods of attributes would block the page for longer than a frame if there are millions of corners.
  for (let corner = 0, count = cornerCount(to); corner < count; corner++)
    target[4 * (newVertices ? newVertices[corner] : corner) + 3] =
      source[4 * (vertices ? vertices[corner] : corner) + 3];
}
