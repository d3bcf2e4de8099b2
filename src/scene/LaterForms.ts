import type { BufferAttribute, BufferGeometry, Material, Mesh } from 'three';
import { warn } from '../material/diagnostics/warn.js';
import { watchFormAngle } from '../material/geometry/formAngles.js';
import { expectForm, isFormed } from '../material/geometry/formGeometry.js';
import { crossAngleOf, type HatchingFormOptions } from '../material/geometry/HatchingFormOptions.js';
import { identityOf } from '../material/geometry/identityOf.js';
import { fadeIn, fadeOut, showLines } from '../material/geometry/lineFades.js';
import {
  MANY_TRIANGLES,
  type PrepareHatchingGeometryOptions,
} from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { hatchNormal } from '../mesh/bake/attributeLayouts.js';
import { runSliced } from '../mesh/runSliced.js';
import { bakeGeometries } from './bakeGeometries.js';
import type { FirstFrame } from './FirstFrame.js';
import {
  askingMaterials,
  cornerCount,
  crossingOf,
  type GeometryPlan,
  type MeshLook,
  type PlannedMesh,
} from './geometryPlans.js';
import type { HideDetail, MakeLevels } from './levelMaker.js';
import { isBatched } from './surfaceMeshes.js';

/** The time in milliseconds for which an angle must stay unchanged before lines are baked at it: a slider may still be moving. */
const ANGLE_REST_MS = 150;

type Plans = ReadonlyMap<BufferGeometry, GeometryPlan>;

/** What bakes share with the call of `applyHatching`, which documents the listeners. */
interface CallParts {
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
interface Field {
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

/**
 * Bakes form fields after a scene was hatched: those of large geometries, so that the first picture does not wait, and those whose angle
 * between crossing lines has changed. Each geometry is in one of these states:
 *
 * | state    | lines follow              | leads to |
 * | -------- | ------------------------- | -------- |
 * | awaited  | the light                 | formed, when the first run ends; after a failure it stays, and the console says why |
 * | formed   | the form                  | turned, when the `crossAngle` of its material changes |
 * | turned   | the form, at a former angle | formed, when the run of the latest angle ends, which starts 150 ms after the change |
 *
 * The first run and the latest run for angles go on side by side, as they bake different geometries; `ready` waits for both. `stop()`
 * aborts both, and leaves every geometry as it is.
 */
export class LaterForms {
  /** The plans of all geometries, without the fields that are baked later. */
  readonly atOnce: Plans;
  /** Resolves when no bake is running. */
  ready: Promise<void> = Promise.resolve();
  private fields: Field[] = [];
  private looks: MeshLook[] = [];
  /** The looks that were given another geometry. */
  private readonly changed = new Set<MeshLook>();
  private readonly stopping = new AbortController();
  /** Aborts the latest run for angles. */
  private turning = new AbortController();

  /**
   * @param plans the plans of all geometries
   * @param materials for each geometry, the material that decides the angle between crossing lines, unless an option does
   * @param prepare options of the bake
   */
  constructor(
    private readonly plans: Plans,
    private readonly materials: Map<BufferGeometry, HatchingMaterial>,
    private readonly prepare: PrepareHatchingGeometryOptions,
    private readonly call: CallParts,
  ) {
    this.atOnce = new Map(
      [...plans].map(([geometry, plan]) => [
        geometry,
        isLater(geometry, plan) ? { ...plan, form: false, group: undefined } : plan,
      ]),
    );
  }

  /** The meshes that were given another geometry, and still have it. */
  get meshes(): Mesh[] {
    return [...this.changed].filter(({ mesh, geometry }) => isSame(mesh.geometry, geometry)).map(({ mesh }) => mesh);
  }

  /** Sets how meshes are drawn until their fields are baked. Must be called before the first draw. */
  drawMeanwhile(baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>): void {
    for (const [source, plan] of this.plans) {
      const drawn = baked.get(source);
      if (!drawn || drawn instanceof Error) continue;
      const hasForm = isFormed(drawn);
      const isAwaited = isLater(source, plan) && !hasForm;
      if (isAwaited) expectForm(drawn);
      else if (!hasForm) continue;
      this.fields.push({ source, plan, drawn, isAwaited });
    }
  }

  /**
   * Starts the bakes.
   *
   * @param looks the looks of the meshes, whose geometries will be replaced
   * @param inPlaceOf the materials that draw instead of those that were planned
   */
  start(looks: readonly MeshLook[], inPlaceOf: ReadonlyMap<Material, HatchingMaterial>): void {
    this.looks = [...looks];
    for (const [geometry, material] of this.materials) {
      this.materials.set(geometry, inPlaceOf.get(material) ?? material);
    }
    for (const field of this.fields) this.watch(field);
    this.prepare.signal?.addEventListener('abort', () => this.stop());
    const awaited = this.fields.filter(({ isAwaited }) => isAwaited);
    if (awaited.length > 0) this.ready = this.bake(awaited, this.stopping.signal, 'lines go by the light');
  }

  /** Stops all bakes, and draws whole meshes. */
  stop(): void {
    this.stopping.abort();
    this.turning.abort();
    for (const field of this.fields) {
      field.hideDetail?.();
      field.hideDetail = undefined;
    }
  }

  /** Leaves a mesh as it is from now on. */
  release(mesh: Mesh): void {
    for (const field of this.fields) field.hideDetail?.(mesh);
    this.looks = this.looks.filter((look) => look.mesh !== mesh);
    this.fields = this.fields.filter(({ drawn }) => this.looks.some(({ geometry }) => geometry === drawn));
    for (const look of this.changed) if (look.mesh === mesh) this.changed.delete(look);
    if (this.fields.length === 0) this.stop();
  }

  /** Watches the angle between crossing lines of a geometry with a field. */
  private watch(field: Field): void {
    const material = this.materials.get(field.source);
    if (!material || !isFormed(field.drawn)) return;
    const form = field.plan.form as HatchingFormOptions;
    watchFormAngle(field.drawn, material, crossAngleOf(form), (crossAngle) => {
      if (this.stopping.signal.aborted) return;
      field.plan = { ...field.plan, form: { ...form, crossAngle } };
      field.isAwaited = true;
      this.turning.abort();
      this.turning = new AbortController();
      this.ready = Promise.all([this.ready, this.turn(this.turning.signal)]).then(() => {});
    });
  }

  /** Bakes fields again, with other angles between crossing lines. The former fields are drawn until then. */
  private async turn(signal: AbortSignal): Promise<void> {
    await new Promise((resume) => setTimeout(resume, ANGLE_REST_MS));
    if (signal.aborted) return;
    const turned = this.fields.filter(({ isAwaited, drawn }) => isAwaited && isFormed(drawn));
    await this.bake(turned, signal, 'lines cross at their former angle');
  }

  /**
   * Bakes fields, and draws with them when all are ready. Never rejects.
   *
   * @param otherwise what is drawn if a bake fails, for the warning
   */
  private async bake(fields: readonly Field[], signal: AbortSignal, otherwise: string): Promise<void> {
    const made = new Set<BufferGeometry>();
    const sayFailed = ({ message }: Error): void =>
      warn(`applyHatching: ${otherwise}, because their form could not be baked. ${message}`);
    try {
      const plans = new Map(fields.map(({ source, plan }) => [source, plan]));
      const options = { ...this.prepare, onProgress: this.call.onFormProgress, signal };
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
      const looks = this.looks.flatMap((look) => {
        const field = fields.find(({ drawn }) => drawn === look.geometry);
        const geometry = field && next.get(field);
        return geometry ? [{ ...look, geometry }] : [];
      });
      const showDetail = await this.makeDetail(looks, signal);
      await this.prepareFrame(looks, signal);
      await this.changeOver(next, signal, showDetail);
    } catch (error) {
      if (signal.aborted) return;
      for (const field of fields) field.isAwaited = false;
      sayFailed(error as Error);
    } finally {
      // Those in use are freed with the rest of the call.
      for (const geometry of made) if (!this.call.geometries.has(geometry)) geometry.dispose();
    }
  }

  /** Makes levels of detail of geometries, if they are requested. Each gets the levels of the geometry that it replaces. */
  private async makeDetail(
    looks: readonly MeshLook[],
    signal: AbortSignal,
  ): Promise<ReadonlyMap<BufferGeometry, () => HideDetail>> {
    const details = new Map<BufferGeometry, () => HideDetail>();
    const { detail } = this.call;
    if (!detail) return details;
    for (const geometry of new Set(looks.map((look) => look.geometry))) {
      const its = looks.filter((look) => look.geometry === geometry);
      details.set(geometry, await detail(its));
      signal.throwIfAborted();
    }
    return details;
  }

  /** Compiles programs and uploads geometries before they are drawn, so that no frame waits for it. */
  private async prepareFrame(looks: readonly MeshLook[], signal: AbortSignal): Promise<void> {
    const { firstFrame } = this.call;
    if (!firstFrame) return;
    firstFrame.compile(looks, [], true);
    await runSliced(firstFrame.upload(looks), { signal });
    await firstFrame.built(signal);
  }

  /**
   * Changes to other geometries. Lines along the light fade into an even grey of their tone, and lines along the form fade in from it.
   */
  private async changeOver(
    next: ReadonlyMap<Field, BufferGeometry>,
    signal: AbortSignal,
    showDetail: ReadonlyMap<BufferGeometry, () => HideDetail>,
  ): Promise<void> {
    const { invalidate = () => {} } = this.call;
    const fading = [...next].filter(([{ drawn }]) => !isFormed(drawn));
    const before = fading.map(([{ drawn }]) => drawn);
    await fadeOut(before, signal, invalidate);
    showLines(before);
    signal.throwIfAborted();
    for (const [field, to] of next) {
      // The meshes may have been released in the meantime.
      if (!this.fields.includes(field)) continue;
      this.exchange(field.drawn, to);
      field.hideDetail?.();
      field.hideDetail = showDetail.get(to)?.();
      field.drawn = to;
      field.isAwaited = false;
      this.call.onFormed(field.source, to, field.plan);
      this.watch(field);
    }
    await fadeIn(
      fading.map(([, to]) => to),
      signal,
      invalidate,
    );
    invalidate();
  }

  /** Replaces a geometry on all meshes that still have it. */
  private exchange(from: BufferGeometry, to: BufferGeometry): void {
    for (const look of this.looks) {
      if (look.geometry !== from) continue;
      look.geometry = to;
      if (isSame(look.mesh.geometry, from)) look.mesh.geometry = to;
      this.changed.add(look);
    }
    const { geometries } = this.call;
    geometries.delete(from);
    geometries.add(to);
    from.dispose();
  }
}

/** Whether a field is baked after the first picture: that of a large geometry, or of one that touches a large one. */
const isLater = (geometry: BufferGeometry, { form, group }: GeometryPlan): boolean =>
  Boolean(form) && (group?.parts.map((part) => part.geometry) ?? [geometry]).some(isLarge);

const isLarge = (geometry: BufferGeometry): boolean => cornerCount(geometry) > 3 * MANY_TRIANGLES;

/** Whether two geometries are the same, or proxies of the same geometry. */
const isSame = (a: BufferGeometry, b: BufferGeometry): boolean => identityOf(a) === identityOf(b);

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

/**
 * For each geometry, the material that decides the angle between crossing lines that follow the form, if there is one and no option
 * does.
 */
export function crossingMaterials(
  planned: readonly PlannedMesh[],
  { form }: PrepareHatchingGeometryOptions,
): Map<BufferGeometry, HatchingMaterial> {
  const materials = new Map<BufferGeometry, HatchingMaterial>();
  if (typeof form === 'object' && form.crossAngle !== undefined) return materials;
  for (const plan of planned) {
    const asking = isBatched(plan.mesh) ? [] : askingMaterials(plan);
    // A material that draws strokes now may draw lines later.
    const crossing = crossingOf(asking) ?? asking[0];
    if (crossing && !materials.has(plan.geometry)) materials.set(plan.geometry, crossing);
  }
  return materials;
}
