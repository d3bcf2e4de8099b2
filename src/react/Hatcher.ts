import type { Material, Mesh, Object3D } from 'three';
import {
  type ApplyHatchingOptions,
  applyHatching,
  type HatchedScene,
  type TonalArtMap,
  withPreset,
} from 'three-hatching';
import { leftAlone, needsMap } from 'three-hatching/facts';
import { restyle } from './restyle.js';
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
  /** Called when the scene was hatched or restyled. */
  onHatched(hatched: HatchedScene): void;
  /** Called when a frame must be drawn because lines change by themselves. */
  invalidate(): void;
  /** Called when the scene could not be hatched; it is unchanged. */
  onError(error: unknown): void;
}

/**
 * Keeps a scene hatched while its options and its meshes change. If new values suffice, the scene is restyled; otherwise it is hatched
 * again. The last look is drawn until the next one is ready.
 */
export class Hatcher {
  private wanted: ApplyHatchingOptions | undefined;
  /** The options of the last attempt, successful or not. */
  private tried: ApplyHatchingOptions | undefined;
  private hatched: HatchedScene | undefined;
  /** The options that the scene is hatched with. */
  private applied: ApplyHatchingOptions | undefined;
  private map: TonalArtMap | null = null;
  private releaseMap = (): void => {};
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
  update(options: ApplyHatchingOptions): void {
    if (this.wanted && sameValue(this.wanted, options)) {
      Object.assign(this.wanted, options);
      return;
    }
    this.wanted = options;
    this.bringUpToDate();
  }

  /** Copies changes of materials, and checks whether the scene has changed since it was hatched. Must be called before each frame. */
  follow(): void {
    if (!this.wanted || !this.snapshot.differs(this.root)) return;
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
    this.releaseMap();
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

  private async take(wanted: ApplyHatchingOptions): Promise<void> {
    this.tried = wanted;
    const options = resolve(wanted);
    this.hideUnhatched(options);
    const map = new WantedMap(options);
    try {
      if (this.drawsWithMap(options)) await map.take();
      this.abort.signal.throwIfAborted();
      if (this.restyled(options, map.map)) await Promise.all(this.hatched!.materials.map(({ ready }) => ready));
      else await this.hatch(options, map);
      this.abort.signal.throwIfAborted();
    } catch (error) {
      map.release();
      // A change during the work may have caused the error. The caller sees the change, and tries again.
      if (!this.abort.signal.aborted && this.snapshot.differs(this.root)) return;
      throw error;
    }
    this.releaseMap();
    this.map = map.map;
    this.releaseMap = map.release;
    this.applied = options;
    this.events.onHatched(this.hatched!);
  }

  /** Whether the hatched scene would need a map with these options. For an unhatched scene `applyHatching` decides that. */
  private drawsWithMap({ material = {} }: ApplyHatchingOptions): boolean {
    if (!this.hatched) return false;
    return typeof material === 'function' ? this.hatched.materials.some(needsMap) : needsMap(material);
  }

  private restyled(options: ApplyHatchingOptions, map: TonalArtMap | null): boolean {
    if (!this.hatched || !this.applied || this.snapshot.differs(this.root)) return false;
    if (!restyle(this.hatched, this.applied, options)) return false;
    for (const material of this.hatched.materials) {
      const { tonalArtMap } = material;
      if (tonalArtMap === this.map || typeof tonalArtMap === 'string') material.tonalArtMap = map;
    }
    return true;
  }

  private async hatch(options: ApplyHatchingOptions, map: WantedMap): Promise<void> {
    const { signal } = this.abort;
    const { filter = () => true } = options;
    this.snapshot.take(this.root);
    const isEmpty = meshesOf(this.root).length === 0;
    const wanted: ApplyHatchingOptions = {
      ...options,
      ...this.drawnBy(),
      tonalArtMap: map.source,
      // React may add a mesh before its geometry, and a helper before any mesh to hatch.
      filter: (mesh) => !isEmpty && hasPositions(mesh) && filter(mesh),
      invalidate: () => this.takeFormed(),
      signal,
    };
    const hatched = this.hatched ? await this.hatched.setPreset(wanted) : await applyHatching(this.root, wanted);
    if (signal.aborted) hatched.dispose();
    signal.throwIfAborted();
    this.hatched = hatched;
    const hasChanged =
      !this.snapshot.hasMeshesOf(this.root) ||
      hatched.skipped.some(({ mesh, error }) => error && this.snapshot.looksOtherwise(mesh));
    // If the snapshot is unchanged, the caller sees the change, and hatches the scene again.
    if (!hasChanged) this.snapshot.take(this.root);
    this.hidden.showAll();
  }

  /** Accepts geometries that the hatched scene has set on meshes. */
  private takeFormed(): void {
    if (this.hatched) this.snapshot.takeGeometries(this.hatched.formed);
    this.events.invalidate();
  }

  private hideUnhatched({ filter = () => true }: ApplyHatchingOptions): void {
    for (const mesh of meshesOf(this.root)) {
      if (!this.snapshot.looksOtherwise(mesh) || !filter(mesh)) continue;
      if (this.hatched) this.hidden.hideOutlines(mesh);
      if (!this.showsUnhatched && !('isHatchingMaterial' in mesh.material)) this.hidden.hide(mesh);
    }
  }
}

const resolve = (options: ApplyHatchingOptions): ApplyHatchingOptions =>
  options.preset === undefined ? options : withPreset(options.preset, options);

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
