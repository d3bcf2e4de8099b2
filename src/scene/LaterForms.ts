import type { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { warn } from '../material/diagnostics/warn.js';
import { watchFormAngle } from '../material/geometry/formAngles.js';
import { expectForm, isFormed } from '../material/geometry/formGeometry.js';
import { crossAngleOf, type HatchingFormOptions } from '../material/geometry/HatchingFormOptions.js';
import { identityOf } from '../material/geometry/identityOf.js';
import { fadeIn, fadeOut, showLines } from '../material/geometry/lineFades.js';
import { MANY_TRIANGLES, type PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { hatchNormal } from '../mesh/bake/attributeLayouts.js';
import { runSliced } from '../mesh/phases.js';
import type { FirstFrame } from './FirstFrame.js';
import { askingMaterials, cornerCount, crossingOf, type GeometryPlan, type MeshLook, type PlannedMesh } from './geometryPlans.js';
import type { MakeLevels } from './levelMaker.js';
import { bakeGeometries } from './making/bakeGeometries.js';
import { isBatched } from './surfaceMeshes.js';

/** The time in milliseconds for which an angle must stay unchanged before lines are baked at it: a slider may still be moving. */
const ANGLE_REST_MS = 150;

/** Listeners to fields that are baked after the first picture: see `ApplyHatchingOptions`. */
interface Listeners {
  onFormProgress?: ((progress: number) => void) | undefined;
  invalidate?: (() => void) | undefined;
}

type Plans = ReadonlyMap<BufferGeometry, GeometryPlan>;

/** A prepared geometry in use, its replacement, and the source geometry and plan of both. */
interface Exchange {
  from: BufferGeometry;
  to: BufferGeometry;
  source: BufferGeometry;
}

/**
 * Bakes form fields after a scene was hatched: those of large geometries, whose lines follow the light until then, so that the first
 * picture does not wait; and those whose angle between crossing lines has changed.
 */
export class LaterForms {
  /** The plans of all geometries, without the fields that are baked later. */
  readonly atOnce: Plans;
  /** Resolves when no bake is running. */
  ready: Promise<void> = Promise.resolve();
  private readonly later = new Map<BufferGeometry, GeometryPlan>();
  /** The prepared geometry in use for each source geometry that has a field or will get one. */
  private readonly drawn = new Map<BufferGeometry, BufferGeometry>();
  private looks: readonly MeshLook[] = [];
  /** The looks that were given another geometry. */
  private readonly changed = new Set<MeshLook>();
  /** The angles, in radians, at which the lines of geometries are still to be baked. */
  private readonly angles = new Map<BufferGeometry, number>();
  private turning = new AbortController();
  private readonly stopping = new AbortController();
  /** Functions that end the drawing of levels of detail, one per geometry. */
  private readonly hideDetail = new Map<BufferGeometry, () => void>();

  /**
   * @param plans the plans of all geometries
   * @param materials for each geometry, the material that decides the angle between crossing lines, unless an option does
   * @param options options of the bake
   * @param listeners are called during and after bakes
   * @param disposables holds the geometries in use
   * @param drawing prepares frames, if the renderer is known, and makes levels of detail, if they are requested
   */
  constructor(
    private readonly plans: Plans,
    private readonly materials: ReadonlyMap<BufferGeometry, HatchingMaterial>,
    private readonly options: PrepareHatchingGeometryOptions,
    private readonly listeners: Listeners,
    private readonly disposables: { dispose(): void }[],
    private readonly drawing: { firstFrame: FirstFrame | null; detail: MakeLevels | null },
  ) {
    this.atOnce = new Map(
      [...plans].map(([geometry, plan]) => {
        const shared = plan.group?.parts.map((part) => part.geometry) ?? [geometry];
        if (!plan.form || !shared.some(isLarge)) return [geometry, plan];
        this.later.set(geometry, plan);
        return [geometry, { ...plan, form: false, group: undefined }];
      }),
    );
  }

  /** The meshes that were given another geometry, and still have it. */
  get meshes(): Mesh[] {
    return [...this.changed].filter(({ mesh, geometry }) => isSame(mesh.geometry, geometry)).map(({ mesh }) => mesh);
  }

  /** Sets how meshes are drawn until their fields are baked. Must be called before the first draw. */
  drawMeanwhile(baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>): void {
    for (const [source, plan] of this.plans) {
      const prepared = baked.get(source);
      if (!prepared || prepared instanceof Error) continue;
      if (this.later.has(source)) expectForm(prepared);
      else if (!isFormed(prepared)) continue;
      this.drawn.set(source, prepared);
      this.watch(source, plan);
    }
  }

  /** Starts the bakes. @param looks the looks of the meshes, whose geometries will be replaced */
  start(looks: readonly MeshLook[]): void {
    this.looks = looks;
    this.options.signal?.addEventListener('abort', () => this.stop());
    const plans = new Map([...this.later].filter(([source]) => this.drawn.has(source)));
    if (plans.size > 0) this.ready = this.replace(plans, this.stopping.signal, 'lines go by the light');
  }

  /** Stops all bakes, and draws whole meshes. */
  stop(): void {
    this.stopping.abort();
    this.turning.abort();
    for (const hide of this.hideDetail.values()) hide();
    this.hideDetail.clear();
  }

  /** Watches the angle between crossing lines of a geometry with a field. */
  private watch(source: BufferGeometry, { form }: GeometryPlan): void {
    const material = this.materials.get(source);
    const drawn = this.drawn.get(source)!;
    if (!material || !isFormed(drawn)) return;
    const angle = crossAngleOf(form as HatchingFormOptions);
    watchFormAngle(drawn, material, angle, (other) => this.turn(source, other));
  }

  /** Bakes a field again, with another angle between crossing lines. The former field is drawn until then. */
  private turn(source: BufferGeometry, angle: number): void {
    if (this.stopping.signal.aborted) return;
    this.angles.set(source, angle);
    this.turning.abort();
    this.turning = new AbortController();
    this.ready = Promise.all([this.ready, this.turned(this.turning.signal)]).then(() => {});
  }

  private async turned(signal: AbortSignal): Promise<void> {
    await new Promise((resume) => setTimeout(resume, ANGLE_REST_MS));
    if (signal.aborted) return;
    const plans = new Map(
      [...this.angles].map(([source, crossAngle]) => {
        const plan = this.plans.get(source)!;
        return [source, { ...plan, form: { ...(plan.form as HatchingFormOptions), crossAngle } }];
      }),
    );
    await this.replace(plans, signal, 'lines cross at their former angle');
    if (!signal.aborted) this.angles.clear();
  }

  /**
   * Bakes fields, and draws with them when all are ready. Never rejects.
   *
   * @param otherwise what is drawn if a bake fails, for the warning
   */
  private async replace(plans: Plans, signal: AbortSignal, otherwise: string): Promise<void> {
    const made = new Set<BufferGeometry>();
    const sayFailed = ({ message }: Error): void =>
      warn(`applyHatching: ${otherwise}, because their form could not be baked. ${message}`);
    try {
      const options = { ...this.options, onProgress: this.listeners.onFormProgress, signal };
      const baked = await bakeGeometries(plans, options, { onBaked: (geometry) => made.add(geometry) });
      const exchanges: Exchange[] = [];
      for (const [source, to] of baked) {
        if (to instanceof Error) sayFailed(to);
        else if (isFormed(to)) exchanges.push({ source, from: this.drawn.get(source)!, to });
      }
      if (exchanges.length === 0) return;
      for (const { from, to } of exchanges) copyOcclusion(from, to);
      const looks = this.looksWith(exchanges);
      const details = await this.makeDetail(looks, signal);
      await this.prepareFrame(looks, signal);
      await this.changeOver(exchanges, plans, signal, details);
      for (const { to } of exchanges) made.delete(to);
    } catch (error) {
      if (!signal.aborted) sayFailed(error as Error);
    } finally {
      for (const geometry of made) geometry.dispose();
    }
  }

  /** Compiles programs and uploads geometries before they are drawn, so that no frame waits for it. */
  private async prepareFrame(looks: readonly MeshLook[], signal: AbortSignal): Promise<void> {
    const { firstFrame } = this.drawing;
    if (!firstFrame) return;
    firstFrame.compile(looks, [], true);
    await runSliced(firstFrame.upload(looks), { signal });
    await firstFrame.built(signal);
  }

  /** The looks that meshes will have. */
  private looksWith(exchanges: readonly Exchange[]): MeshLook[] {
    return this.looks.flatMap((look) => {
      const exchange = exchanges.find(({ from }) => from === look.geometry);
      return exchange ? [{ ...look, geometry: exchange.to }] : [];
    });
  }

  /** Makes levels of detail of geometries, if they are requested. Each gets the levels of the geometry that it replaces. */
  private async makeDetail(
    looks: readonly MeshLook[],
    signal: AbortSignal,
  ): Promise<ReadonlyMap<BufferGeometry, () => () => void>> {
    const details = new Map<BufferGeometry, () => () => void>();
    const { detail } = this.drawing;
    if (!detail) return details;
    for (const geometry of new Set(looks.map((look) => look.geometry))) {
      const its = looks.filter((look) => look.geometry === geometry);
      details.set(geometry, await detail(its));
      signal.throwIfAborted();
    }
    return details;
  }

  /**
   * Changes to other geometries. Lines along the light fade into an even grey of their tone, and lines along the form fade in from it.
   */
  private async changeOver(
    exchanges: readonly Exchange[],
    plans: Plans,
    signal: AbortSignal,
    details: ReadonlyMap<BufferGeometry, () => () => void>,
  ): Promise<void> {
    const { invalidate = () => {} } = this.listeners;
    const fading = exchanges.filter(({ from }) => !isFormed(from));
    const before = fading.map(({ from }) => from);
    await fadeOut(before, signal, invalidate);
    showLines(before);
    signal.throwIfAborted();
    for (const { from, to, source } of exchanges) {
      this.exchange(from, to);
      this.hideDetail.get(from)?.();
      this.hideDetail.delete(from);
      const showDetail = details.get(to);
      if (showDetail) this.hideDetail.set(to, showDetail());
      this.drawn.set(source, to);
      this.watch(source, plans.get(source)!);
    }
    await fadeIn(
      fading.map(({ to }) => to),
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
    this.disposables[this.disposables.indexOf(from)] = to;
    from.dispose();
  }
}

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
