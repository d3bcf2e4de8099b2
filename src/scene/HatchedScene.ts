import { type BufferGeometry, Color, type Material, type Mesh, type Object3D } from 'three';
import { HATCHING_DEFAULTS } from '../look/hatchingProperties.js';
import type { SceneExtent } from '../material/fading/SceneExtent.js';
import { identityOf } from '../material/geometry/identityOf.js';
import { HatchingComposition } from '../material/groups/HatchingComposition.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingOutlines } from '../material/outlines/HatchingOutlines.js';
import { wantsIntersections } from '../material/outlines/IntersectingOutlines.js';
import { loadIntersections } from '../material/outlines/loadIntersections.js';
import type { ApplyHatchingOptions, HatchingPreset } from './ApplyHatchingOptions.js';
import { lookOptions } from './applyOptions.js';
import { beginCall, type CallUnderWay } from './beginCall.js';
import type { ChosenMeshes, MeshHolder } from './chooseMeshes.js';
import { growExtent } from './dressLooks.js';
import { GivenValues } from './GivenValues.js';
import type { MeshLook } from './geometryPlans.js';
import type { BakedGeometry, LookMakers, MadeLooks, SceneStyle } from './HatchingCall.js';
import type { LaterForms } from './LaterForms.js';
import type { HideDetail } from './levelMaker.js';
import { exchangeLook, type InPlaceOf, isAsHatched, isOccluded, isSame, lookOf, replaced } from './meshLooks.js';
import { type PreparedCall, prepareLooks } from './prepareLooks.js';
import type { PresetName } from './presets.js';
import type { SkippedMesh } from './SkippedMesh.js';
import type { StyleChange } from './StyleChange.js';
import { COMPOSITION_NAMES, numbersOf, plainOf, styleOf } from './sceneStyles.js';
import { claimMeshes, isHatching, materialsOf } from './surfaceMeshes.js';

/** How a change of a hatched scene is watched and aborted. */
export interface HatchingTask {
  /** Aborts the change: the scene stays as it is, and the promise is rejected with the signal's reason. */
  signal?: AbortSignal | undefined;
  /** Called with the progress, from 0 to 1. */
  onProgress?: ((progress: number) => void) | undefined;
}

/** A hatched mesh. */
interface Part {
  readonly mesh: Mesh;
  readonly before: MeshLook;
  readonly after: MeshLook;
  readonly batch: Batch;
  outlines: HatchingOutlines | null;
  /** Why it has no outlines, if it should have some. */
  without: SkippedMesh | undefined;
  readonly unclaim: () => void;
}

/** What was made for meshes that were hatched together. */
interface Batch {
  readonly geometries: Set<BufferGeometry>;
  readonly forms: LaterForms | null;
  readonly hideDetail: HideDetail | undefined;
}

/**
 * A scene hatched by `applyHatching`: the handle by which it is changed, brought up to date and given back.
 *
 * The materials of the scene, its sources, stay the truth: what you change in them, such as a colour, a map, the opacity, the visibility
 * or the sides, counts in the next frame. A parameter that you passed, and a value that you have set on the hatched material, stays.
 */
export class HatchedScene {
  /** @internal */
  readonly isHatchedScene = true;
  /** The hatched meshes, by their identities. */
  private readonly parts = new Map<object, Part>();
  private batches: Batch[] = [];
  private baked = new Map<BufferGeometry, BakedGeometry>();
  private style: SceneStyle;
  /** The numbers that looks gave the composition. */
  private composed: GivenValues;
  private hatchingMaterials: readonly HatchingMaterial[] = [];
  private ownOutlines: readonly HatchingOutlines[] = [];
  private leftOut: readonly SkippedMesh[] = [];
  private readonly paper = new Color();
  /** The options as they were passed, without those of the preset. */
  private given: ApplyHatchingOptions;
  /** Materials whose values others have taken over: their programs serve the next frame. */
  private spent: Material[] = [];
  private underWay: CallUnderWay | null = null;
  /** The options of a call of `setPreset` that is under way. */
  private wanted: ApplyHatchingOptions | null = null;
  /** Meshes that were released while a call is under way. */
  private released = new Set<object>();
  private isDisposed = false;

  /** @param options as they were passed, without those of the preset @internal */
  constructor(
    private readonly root: Object3D,
    { signal, onProgress, ...options }: ApplyHatchingOptions,
    private readonly makers: LookMakers,
  ) {
    this.given = options;
    this.style = styleOf(options, new HatchingComposition());
    const { composition } = this.style;
    composition.setValues(numbersOf(this.style));
    this.composed = new GivenValues(composition, COMPOSITION_NAMES);
  }

  /** All new materials; you may change them. */
  get materials(): readonly HatchingMaterial[] {
    return this.hatchingMaterials;
  }

  /**
   * What counts for the whole picture: exposure, depth, focus and vignette. All new materials share it, unless their parameters name
   * another.
   */
  get composition(): HatchingComposition {
    return this.style.composition;
  }

  /** The outlines of all meshes, if requested; you may change their materials. Those share one whose meshes do. */
  get outlines(): readonly HatchingOutlines[] {
    return this.ownOutlines;
  }

  /** Meshes that were left alone, or have no outlines, as of the last change. */
  get skipped(): readonly SkippedMesh[] {
    const without = [...this.parts.values()].flatMap((part) => part.without ?? []);
    return [...this.leftOut, ...without];
  }

  /**
   * The colour of the paper, to clear the canvas with: `scene.background = hatched.background`. It is one object, which `setPreset`
   * changes.
   */
  get background(): Color {
    return this.paper.set(this.presentPaper);
  }

  /** The material that a mesh is hatched with, or the materials in the order of its own; undefined if the mesh is not hatched. */
  materialOf(mesh: Mesh): HatchingMaterial | (HatchingMaterial | Material)[] | undefined {
    return this.partOf(mesh)?.after.material as HatchingMaterial | Material[] | undefined;
  }

  /** The outlines of a mesh; undefined if it has none. */
  outlineOf(mesh: Mesh): HatchingOutlines | undefined {
    return this.partOf(mesh)?.outlines ?? undefined;
  }

  /**
   * Hatches what was added below the root, or was given another geometry or material, and releases what is no longer below it. Nothing
   * changes before everything is ready. The promise resolves with this scene. A later call for the same root ends this one: then it is
   * rejected with an `AbortError`.
   */
  update(task: HatchingTask = {}): Promise<this> {
    // What setPreset has begun is completed.
    return this.change(this.wanted, task);
  }

  /**
   * Gives the scene another look, in place: meshes keep their hatched materials, with other values, and what you have changed on them
   * and on the materials of the scene stays, also on parts that are not below the root at present. Does all that `update` does. The
   * other options stay those of before, unless `options` has others.
   *
   *     await hatched.setPreset('chalk');
   *     await hatched.setPreset({ preset: 'pen', material: { ink: 'navy' }, outlines: false });
   *
   * Nothing changes before everything is ready. A later call for the same root ends this one: then it is rejected with an
   * `AbortError`.
   *
   * @param look a preset, or options in place of `preset`, `material`, `outlines` and `tonalArtMap` of before
   */
  setPreset(
    look: PresetName | HatchingPreset | ApplyHatchingOptions,
    options: ApplyHatchingOptions = {},
  ): Promise<this> {
    const chosen = lookOptions(look, options);
    const { preset, material, outlines, tonalArtMap, ...others } = this.wanted ?? this.given;
    const { signal, onProgress, ...given } = { ...others, ...chosen };
    // Anything else than an object is reported as wrong options.
    return this.change(chosen ? given : chosen, { signal, onProgress });
  }

  /**
   * Gives the meshes at or below an object their former geometries and materials back, and frees what only they need: geometries,
   * textures, outlines and materials. `update` hatches them again if they are still below the root and `userData.hatching` is not false.
   */
  release(part: Object3D): void {
    part.traverse((object) => {
      if (!('isMesh' in object)) return;
      this.released.add(identityOf(object));
      const held = this.partOf(object as Mesh);
      if (held) this.takeOff(held);
      this.leftOut = this.leftOut.filter(({ mesh }) => identityOf(mesh) !== identityOf(object));
    });
    this.sweep();
  }

  /**
   * Resolves with the meshes that were given another geometry, when all lines lie as their materials ask. Meshes of more than 200,000
   * triangles whose lines are to follow the form follow the light at first, so that the first picture does not wait; and after the
   * `crossAngle` of a material has changed, lines cross at the new angle only when their field is baked again. If there is nothing to
   * wait for, it resolves at once. It never rejects: if a form could not be baked, the console says why. `restore()` stops the bake.
   */
  get formReady(): Promise<readonly Mesh[]> {
    return Promise.all(this.batches.map(({ forms }) => forms?.ready)).then(() => this.formed);
  }

  /** The meshes that were given another geometry so far. @internal */
  get formed(): readonly Mesh[] {
    return this.batches.flatMap(({ forms }) => forms?.meshes ?? []);
  }

  /**
   * Gives every mesh back its former geometry and material, and removes its outlines. A geometry or material that you have set since
   * stays. A second call does nothing. The new geometries and materials stay usable until `dispose()`, and `update()` draws with them
   * again.
   */
  restore(): void {
    this.underWay?.giveWay();
    for (const part of this.parts.values()) this.takeOff(part);
    for (const { forms } of this.batches) forms?.stop();
  }

  /** Restores the meshes, and frees all new geometries, materials and outlines, and a map that was generated for this scene. */
  dispose(): void {
    this.restore();
    this.isDisposed = true;
    this.sweep();
    this.freeSpent();
    for (const one of this.style.disposables.splice(0)) one.dispose();
  }

  /** Gives meshes whose former geometry or material was set back, as by helpers that swap materials for a moment, their new look again. @internal */
  dress(): void {
    for (const { before, after } of this.parts.values()) {
      const { mesh, geometry, material } = after;
      if (mesh.geometry !== geometry || mesh.material !== material) exchangeLook(before, after);
    }
  }

  /** Whether `mesh` is among the hatched meshes. @internal */
  holds(mesh: Mesh): boolean {
    return this.parts.has(identityOf(mesh));
  }

  /** Makes the meshes hatched for the first time. @internal */
  async begin(call: CallUnderWay): Promise<this> {
    return this.run(call, this.style, true);
  }

  private partOf(mesh: Mesh): Part | undefined {
    return this.parts.get(identityOf(mesh));
  }

  private get presentPaper(): Color | string | number {
    const [first] = this.hatchingMaterials;
    if (first) return first.paper;
    const { material } = this.style.options;
    const paper = typeof material === 'object' ? material.paper : undefined;
    return (paper as Color | string | number | undefined) ?? HATCHING_DEFAULTS.paper;
  }

  /** @param restyle the options of another look; null keeps the present one */
  private change(restyle: ApplyHatchingOptions | null, { signal, onProgress }: HatchingTask): Promise<this> {
    try {
      if (this.isDisposed) throw new Error('HatchedScene: it was disposed of. Call applyHatching again.');
      const isNew = restyle !== null;
      const style = isNew ? styleOf(restyle, this.style.composition) : this.style;
      const holder: MeshHolder = {
        holds: (mesh) => this.holds(mesh),
        keeps: (mesh) => !isNew && isAsHatched(this.partOf(mesh)!),
      };
      const detached = [...this.parts.values()].filter(({ mesh }) => isNew && !isBelow(mesh, this.root));
      const options = { ...style.options, signal, onProgress };
      const call = beginCall(
        this.root,
        options,
        holder,
        detached.map(({ mesh }) => mesh),
      );
      this.wanted = restyle;
      return call.promised(this.run(call, style));
    } catch (error) {
      return Promise.reject(error);
    }
  }

  /** Makes what a call needs, and shows it. */
  private async run(call: CallUnderWay, style: SceneStyle, isFirst = false): Promise<this> {
    this.underWay = call;
    this.released.clear();
    const { wanted } = this;
    let goesOn = false;
    try {
      const change = wanted ? new (await import('./StyleChange.js')).StyleChange(this.style, wanted) : null;
      const prepared = await prepareLooks(call, this.makers, {
        style,
        reusable: this.baked,
        mustHatch: isFirst || change !== null,
        isDetached: (mesh) => !isBelow(mesh, this.root),
        fieldFrameOf: (mesh) => this.partOf(mesh)?.after.fieldFrame,
        takeEdits: (added) => change?.takeEdits(added),
        asBefore: (work) => this.suspended(work),
      });
      call.signal.throwIfAborted();
      call.end();
      if (wanted) this.given = wanted;
      this.show(call.choice, prepared, style, change);
      await this.intersect(call.signal);
      goesOn = prepared?.made.forms != null;
      return this;
    } finally {
      call.end();
      if (!goesOn) call.unlink();
      if (this.underWay === call) {
        this.underWay = null;
        this.wanted = null;
      }
    }
  }

  /** Computes the lines where surfaces meet, if outlines ask for them. Without them the scene is hatched all the same. */
  private async intersect(signal: AbortSignal): Promise<void> {
    if (!this.ownOutlines.some(wantsIntersections)) return;
    try {
      await (await loadIntersections()).settleIntersections(this.root, { signal });
    } catch {}
  }

  /** Shows the new looks, all at once, and takes what is gone off the scene. */
  private show(
    choice: ChosenMeshes,
    prepared: PreparedCall | null,
    style: SceneStyle,
    change: StyleChange | null,
  ): void {
    const { made, outlineMaker = null, madeMaps = [] } = prepared ?? {};
    const former = this.style;
    this.freeSpent();
    const { inPlaceOf, spent } = change?.finish(outlineMaker) ?? { inPlaceOf: new Map(), spent: [] };
    this.spent = spent;
    const looks = (made?.looks ?? []).filter(({ mesh }) => !this.released.has(identityOf(mesh)));
    for (const look of looks) look.material = replaced(look.material, inPlaceOf);

    const kept = new Set(choice.kept.map(identityOf));
    // Occlusion of a mesh's own outlasts the change if the geometry does.
    const occluded = new Map(looks.map(({ mesh }) => [mesh, mesh.geometry]));
    const outlined = new Map<object, HatchingOutlines>();
    for (const [key, part] of this.parts) {
      if (kept.has(key)) exchangeLook(part.before, part.after);
      else {
        if (part.outlines) outlined.set(key, part.outlines);
        this.takeOff(part);
      }
    }

    this.style = style;
    if (change) this.compose(former);
    if (made) this.take(made, looks, madeMaps);
    this.measure(former.measures?.extent);
    style.composition.refit();
    if (outlineMaker) style.outlineMaker = outlineMaker;
    const batch: Batch = {
      geometries: made?.geometries ?? new Set(),
      forms: made?.forms ?? null,
      hideDetail: made?.showDetail?.(),
    };
    this.batches.push(batch);
    for (const after of looks) {
      this.putOn(after, batch);
      const geometry = occluded.get(after.mesh)!;
      if (isOccluded(geometry, after.geometry)) after.mesh.geometry = geometry;
    }
    for (const one of outlineMaker?.outlines ?? []) this.addOutlines(one, outlined, inPlaceOf);
    for (const one of outlineMaker?.without ?? []) {
      const part = this.partOf(one.mesh);
      if (part) part.without = one;
    }
    this.ownGeometries(batch);
    this.leftOut = [...choice.skipped, ...(made?.failed ?? [])];
    if (change) this.free(former);
    this.sweep();
    this.paper.set(this.presentPaper);
    batch.forms?.start(looks, inPlaceOf as ReadonlyMap<Material, HatchingMaterial>);
    for (const { mesh } of looks) {
      for (const material of materialsOf(mesh)) if (isHatching(material)) material.announce?.(mesh);
    }
  }

  /** Sets the numbers of the composition of a new look. What was edited stays, unless it was passed with the look. */
  private compose(former: SceneStyle): void {
    const { composition } = this.style;
    if (composition !== former.composition) {
      this.composed = new GivenValues(composition, COMPOSITION_NAMES);
      return;
    }
    const { material } = this.given;
    if (typeof material === 'object' && this.given.preset !== undefined)
      composition.setValues(plainOf(material.composition));
    const numbers = new HatchingComposition(numbersOf(this.style)) as HatchingComposition & Record<string, unknown>;
    for (const name of COMPOSITION_NAMES) this.composed.give(composition, name, numbers[name]);
  }

  /** Gives compositions the extent of the scene, unless they have one of their own. */
  private measure(former: SceneExtent | undefined): void {
    const { measures, replacements, composition } = this.style;
    if (!measures) return;
    const all = new Set([composition, ...[...replacements.values()].map(({ material }) => material.composition)]);
    for (const one of all) if (one.extent === null || one.extent === former) one.extent = measures.extent;
  }

  /** Takes over what was made for a look. */
  private take(made: MadeLooks, looks: readonly MeshLook[], madeMaps: { dispose(): void }[]): void {
    const { style } = this;
    for (const [key, one] of made.replacements) {
      style.replacements.set(key, one);
      one.start();
    }
    for (const [name, map] of made.maps) style.maps.set(name, map);
    style.disposables.push(...madeMaps);
    for (const [source, one] of made.baked) this.baked.set(source, one);
    if (style.measures) for (const look of looks) growExtent(style.measures.extent, look);
    else if (looks.length > 0) style.measures = made.measures;
  }

  private putOn(after: MeshLook, batch: Batch): void {
    const { mesh } = after;
    const before = lookOf(mesh);
    exchangeLook(before, after);
    const unclaim = claimMeshes([mesh]);
    this.parts.set(identityOf(mesh), { mesh, before, after, batch, outlines: null, without: undefined, unclaim });
  }

  /** Adds outlines to their mesh. Outlines that the mesh had before stay in use. */
  private addOutlines(
    made: HatchingOutlines,
    outlined: ReadonlyMap<object, HatchingOutlines>,
    inPlaceOf: InPlaceOf,
  ): void {
    const mesh = made.mesh!;
    const part = this.partOf(mesh);
    if (!part) {
      made.dispose();
      return;
    }
    const former = outlined.get(identityOf(mesh));
    part.outlines = former ?? made;
    if (former) {
      if (!inPlaceOf.has(made.material)) former.material = made.material;
      made.dispose();
    } else made.material = (inPlaceOf.get(made.material) ?? made.material) as HatchingOutlines['material'];
    mesh.add(part.outlines);
  }

  /** Takes over geometries in use that were baked earlier, and whose other users have been released in the meantime. */
  private ownGeometries({ geometries }: Batch): void {
    const owned = new Set(this.batches.flatMap((batch) => [...batch.geometries]));
    const used = this.usedGeometries;
    for (const { geometry } of this.baked.values())
      if (used.has(geometry) && !owned.has(geometry)) geometries.add(geometry);
  }

  /** Gives a mesh its former look back. */
  private takeOff({ mesh, before, after, batch, outlines, unclaim }: Part): void {
    outlines?.removeFromParent();
    exchangeLook(after, before);
    batch.hideDetail?.(mesh);
    batch.forms?.release(mesh);
    unclaim();
    this.parts.delete(identityOf(mesh));
  }

  private get usedGeometries(): ReadonlySet<BufferGeometry> {
    return new Set([...this.parts.values()].map(({ after }) => after.geometry));
  }

  /** Frees what no mesh needs any more. */
  private sweep(): void {
    const { style, usedGeometries } = this;
    const parts = [...this.parts.values()];
    const materials = new Set(parts.flatMap(({ after }) => after.material));
    for (const [key, one] of style.replacements) {
      if (materials.has(one.material)) continue;
      one.stop();
      one.material.dispose();
      style.replacements.delete(key);
    }
    for (const [surface, { material }] of style.outlineMaker?.looks ?? []) {
      if (materials.has(surface)) continue;
      material.dispose();
      style.outlineMaker?.looks.delete(surface);
    }
    const outlines = new Set(parts.flatMap((part) => part.outlines ?? []));
    for (const one of this.ownOutlines) if (!outlines.has(one)) one.dispose();
    for (const { geometries } of this.batches) {
      for (const geometry of geometries) {
        if (usedGeometries.has(geometry)) continue;
        geometry.dispose();
        geometries.delete(geometry);
      }
    }
    for (const [source, { geometry }] of this.baked) if (!usedGeometries.has(geometry)) this.baked.delete(source);
    const drawing = new Set(parts.map(({ batch }) => batch));
    this.batches = this.batches.filter((batch) => batch.geometries.size > 0 || drawing.has(batch));
    this.hatchingMaterials = [...style.replacements.values()].map(({ material }) => material);
    this.ownOutlines = [...outlines];
  }

  /** Frees what is left of a former look. */
  private free({ replacements, outlineMaker, disposables }: SceneStyle): void {
    const held = new Set<Material>([...this.style.replacements.values()].map(({ material }) => material));
    for (const one of replacements.values()) {
      if (held.has(one.material)) continue;
      one.stop();
      one.material.dispose();
    }
    const drawing = new Set([...(this.style.outlineMaker?.looks.values() ?? [])].map(({ material }) => material));
    for (const { material } of outlineMaker?.looks.values() ?? []) if (!drawing.has(material)) material.dispose();
    for (const one of disposables) one.dispose();
  }

  private freeSpent(): void {
    for (const material of this.spent.splice(0)) material.dispose();
  }

  /** Runs a function while the meshes have their former geometries and materials. */
  private suspended<Result>(work: () => Result): Result {
    const parts = [...this.parts.values()];
    const drawn = parts.map(({ mesh: { geometry }, after }) =>
      isOccluded(geometry, after.geometry) ? geometry : null,
    );
    for (const { before, after } of parts) exchangeLook(after, before);
    try {
      return work();
    } finally {
      for (const [i, { before, after }] of parts.entries()) {
        exchangeLook(before, drawn[i] ? { ...after, geometry: drawn[i] } : after);
      }
    }
  }
}

function isBelow(object: Object3D, root: Object3D): boolean {
  for (let above: Object3D | null = object; above !== null; above = above.parent) if (isSame(above, root)) return true;
  return false;
}
