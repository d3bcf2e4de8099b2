import type { Material, Mesh, Object3D } from 'three';
import { type ApplyHatchingOptions, applyHatching, type HatchedScene } from 'three-hatching';
import { leftAlone } from 'three-hatching/facts';
import { type HatchedOptions, NO_OPTIONS } from './hatchedOptions.js';
import { sameValue } from './sameValue.js';
import { WantedMap } from './sharedMaps.js';

/** Hides meshes for a while by removing them from all layers. Properties that React sets, such as `visible`, stay. */
class HiddenMeshes {
  private readonly masks = new Map<Object3D, number>();

  hide(object: Object3D): void {
    if (this.masks.has(object)) return;
    this.masks.set(object, object.layers.mask);
    object.layers.mask = 0;
  }

  /** Hides the outlines of a mesh whose geometry has changed. Outlines of a hidden mesh are hidden with it. */
  hideOutlines({ children }: Mesh): void {
    for (const child of children) if (isOutlines(child) && child.layers.mask !== 0) this.hide(child);
  }

  /** Shows all meshes again, and then their outlines, which follow the layers of the meshes. */
  showAll(): void {
    for (const isLater of [false, true])
      for (const [object, mask] of this.masks) if (isOutlines(object) === isLater) object.layers.mask = mask;
    this.masks.clear();
  }
}

const isOutlines = (object: Object3D): boolean => 'isHatchingOutlines' in object;

/** The listeners of a `Hatcher`. */
export interface HatcherEvents {
  /** Called when the scene was hatched or changed. */
  onHatched(hatched: HatchedScene): void;
  /** Called when a frame must be drawn because lines change by themselves. */
  invalidate(): void;
  /** Called when the scene could not be hatched or changed; it is as before. */
  onError(error: unknown): void;
}

/**
 * Keeps a scene hatched while its options and its meshes change, one change after another. The last look is drawn until the next one is
 * ready.
 */
export class Hatcher {
  private wanted: HatchedOptions | undefined;
  /** The options of the last attempt, successful or not. */
  private tried: HatchedOptions | undefined;
  private hatched: HatchedScene | undefined;
  /** The options of the present look, and its map. */
  private applied: { wanted: HatchedOptions; map: WantedMap } | undefined;
  private readonly snapshot = new SceneSnapshot();
  private readonly abort = new AbortController();
  private readonly hidden = new HiddenMeshes();
  private isBusy = false;

  /**
   * @param showsUnhatched whether meshes are drawn with their own materials until they are hatched
   * @param drawnBy returns the renderer and the camera that draw the scene, if there are any
   */
  constructor(
    private readonly root: Object3D,
    private readonly showsUnhatched: boolean,
    private readonly events: HatcherEvents,
    private readonly drawnBy: () => Pick<ApplyHatchingOptions, 'renderer' | 'camera'> = () => ({}),
  ) {}

  /** Hatches the scene with these options. A new function alone changes nothing; the latest function is called when it is needed. */
  update(options: HatchedOptions): void {
    if (this.wanted && sameValue(this.wanted, options)) {
      Object.assign(this.wanted, options);
      return;
    }
    // An option that is left out returns to its default.
    this.wanted = { ...NO_OPTIONS, ...options };
    this.bringUpToDate();
  }

  /** Checks whether the scene has changed since it was hatched. Must be called before each frame. */
  follow(): void {
    if (!this.wanted || !this.snapshot.differs(this.root)) return;
    // Helpers give meshes other materials for a moment.
    this.hatched?.dress();
    if (!this.snapshot.differs(this.root)) return;
    // A change during the work is hatched right after it.
    if (this.isBusy) this.hideUnhatched(this.wanted);
    else this.bringUpToDate();
  }

  /** Restores the former look of the scene, and frees all memory. */
  dispose(): void {
    this.abort.abort();
    this.hidden.showAll();
    this.hatched?.dispose();
    this.hatched = undefined;
    this.applied?.map.release();
  }

  private async bringUpToDate(): Promise<void> {
    if (this.isBusy) return;
    this.isBusy = true;
    const { signal } = this.abort;
    try {
      while (!signal.aborted && !this.isUpToDate()) await this.take(this.wanted!);
    } catch (error) {
      // With this snapshot there is no further attempt before something changes.
      this.snapshot.take(this.root);
      this.hidden.showAll();
      if (!signal.aborted) this.events.onError(error);
    } finally {
      this.isBusy = false;
    }
  }

  private isUpToDate(): boolean {
    return this.tried === this.wanted && !this.snapshot.differs(this.root);
  }

  private async take(wanted: HatchedOptions): Promise<void> {
    this.tried = wanted;
    this.hideUnhatched(wanted);
    this.snapshot.take(this.root);
    // React may add helpers, and meshes without geometry, before there is anything to hatch.
    if (!this.hatched && !meshesOf(this.root).some((mesh) => isWanted(mesh, wanted))) return;
    try {
      if (this.hatched && this.applied?.wanted === wanted) await this.bringIn(this.hatched, wanted);
      else await this.restyle(wanted);
    } catch (error) {
      // A change during the work may have caused the error. The caller sees the change, and tries again.
      if (!this.abort.signal.aborted && this.snapshot.differs(this.root)) return;
      throw error;
    }
    this.takeLooks();
    this.hidden.showAll();
    this.events.onHatched(this.hatched!);
  }

  /** Hatches what was added, and releases what is gone. */
  private async bringIn(hatched: HatchedScene, wanted: HatchedOptions): Promise<void> {
    const { signal } = this.abort;
    await hatched.update({ signal, onProgress: (progress) => wanted.onProgress?.(progress) });
    signal.throwIfAborted();
  }

  /** Hatches the scene, or gives it another look. */
  private async restyle(wanted: HatchedOptions): Promise<void> {
    const { signal } = this.abort;
    const map = new WantedMap(wanted);
    try {
      const options: ApplyHatchingOptions = {
        ...withLatestFunctions(wanted),
        ...this.drawnBy(),
        tonalArtMap: map.source,
        filter: (mesh) => isWanted(mesh, wanted),
        invalidate: () => this.takeFormed(),
        signal,
      };
      const hatched = await (this.hatched?.setPreset(options) ?? applyHatching(this.root, options));
      if (signal.aborted) hatched.dispose();
      signal.throwIfAborted();
      this.hatched = hatched;
    } catch (error) {
      map.release();
      throw error;
    }
    this.applied?.map.release();
    this.applied = { wanted, map };
  }

  /** Accepts the looks that the scene was given. If it has changed meanwhile, the caller sees the change, and hatches it again. */
  private takeLooks(): void {
    const hasChanged =
      !this.snapshot.hasMeshesOf(this.root) ||
      this.hatched!.skipped.some(({ mesh, error }) => error && this.snapshot.looksOtherwise(mesh));
    if (!hasChanged) this.snapshot.take(this.root);
  }

  /** Accepts geometries that the hatched scene has set on meshes. */
  private takeFormed(): void {
    if (this.hatched) this.snapshot.takeGeometries(this.hatched.formed);
    this.events.invalidate();
  }

  private hideUnhatched({ filter = () => true }: HatchedOptions): void {
    for (const mesh of meshesOf(this.root)) {
      if (!this.snapshot.looksOtherwise(mesh) || !filter(mesh)) continue;
      if (this.hatched) this.hidden.hideOutlines(mesh);
      if (!this.showsUnhatched && !isHatching(mesh)) this.hidden.hide(mesh);
    }
  }
}

/** The options, whose functions call those that the object has then. */
const withLatestFunctions = (wanted: HatchedOptions): HatchedOptions =>
  Object.fromEntries(
    Object.entries(wanted).map(([name, value]) => [
      name,
      typeof value === 'function' ? (...given: unknown[]) => Reflect.get(wanted, name)(...given) : value,
    ]),
  );

/** Whether a mesh is to be hatched. React may add it before its geometry. */
const isWanted = (mesh: Mesh, { filter = () => true }: HatchedOptions): boolean => hasPositions(mesh) && filter(mesh);

/** Whether a mesh has a hatching material. It has none before React attaches it. */
const isHatching = ({ material }: Mesh): boolean => Boolean(material) && 'isHatchingMaterial' in material;

const hasPositions = ({ geometry }: Mesh): boolean => (geometry?.attributes.position?.count ?? 0) > 0;

/** A record of the meshes to hatch in a scene, in order, with their geometries and materials, which shows when the scene changes. */
class SceneSnapshot {
  private readonly meshes: Mesh[] = [];
  private readonly geometries: Mesh['geometry'][] = [];
  private readonly materials: (Material | Material[])[] = [];

  take(root: Object3D): void {
    this.meshes.length = 0;
    this.geometries.length = 0;
    this.materials.length = 0;
    for (const object of meshesOf(root)) {
      this.meshes.push(object);
      this.geometries.push(object.geometry);
      this.materials.push(object.material);
    }
  }

  /** Whether a mesh was added or removed, or has another geometry or material. Allocates nothing. */
  differs(root: Object3D): boolean {
    return this.compare(root, 0) !== this.meshes.length;
  }

  /** Records the present geometries of meshes, whose change was intended. */
  takeGeometries(meshes: readonly Mesh[]): void {
    for (const mesh of meshes) {
      const place = this.meshes.indexOf(mesh);
      if (place >= 0) this.geometries[place] = mesh.geometry;
    }
  }

  /** Whether a mesh is new, or has another geometry or material. */
  looksOtherwise(mesh: Mesh): boolean {
    const place = this.meshes.indexOf(mesh);
    return place < 0 || mesh.geometry !== this.geometries[place] || mesh.material !== this.materials[place];
  }

  /** Whether the scene has the same meshes, whatever their geometries and materials. */
  hasMeshesOf(root: Object3D): boolean {
    const meshes = meshesOf(root);
    return meshes.length === this.meshes.length && meshes.every((mesh, i) => mesh === this.meshes[i]);
  }

  /**
   * Compares the meshes at or below an object with those recorded from `place` on. Returns the place after them, or NaN if they differ.
   */
  private compare(object: Object3D, place: number): number {
    let next = place;
    if (isHatched(object)) {
      const isKnown =
        object === this.meshes[place] &&
        object.geometry === this.geometries[place] &&
        object.material === this.materials[place];
      if (!isKnown) return Number.NaN;
      next++;
    }
    for (const child of object.children) next = this.compare(child, next);
    return next;
  }
}

/** All meshes at or below an object that are to be hatched. Helpers, which are left alone, may change freely. */
function meshesOf(root: Object3D): Mesh[] {
  return (root.getObjectsByProperty('isMesh', true) as Mesh[]).filter(isHatched);
}

const isHatched = (object: Object3D): object is Mesh => 'isMesh' in object && leftAlone(object as Mesh) === undefined;
