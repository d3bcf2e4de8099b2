import { DataTexture, RGBAIntegerFormat, type Sphere, UnsignedIntType, Vector4 } from 'three';
import { pullTextureSize } from '../../mesh/bake/pullLayout.js';
import { type ContourSearch, findCandidates } from '../../mesh/features/contourCandidates.js';
import { runTask } from '../../worker/runTask.js';
import type { OutlineData } from '../geometry/OutlineData.js';

/**
 * The sine of the angle through which the direction to the eye may turn before a new list is needed. A smaller angle makes shorter
 * lists.
 */
const SINE = Math.sin((0.75 * Math.PI) / 180);
/** The same sine for lists from the worker, which arrive later. A new one is requested after half of the angle. */
const SINE_IN_WORKER = Math.sin((3 * Math.PI) / 180);
/** The factor by which a new texture is larger than needed. Textures never become smaller. */
const GROWTH = 1.3;

/** A list of the primitives of one geometry that may hold an outline, as seen by one camera. */
export class ContourList {
  /** The indices of the primitives, four per texel. */
  texture: DataTexture | null = null;
  count = 0;
  /** The outline data that the list was made from. */
  private data: OutlineData | null = null;
  /** The eye position that the list was made for. */
  private readonly eye = new Vector4();
  /** The distance that the eye may move before the list is out of date; negative if there is no list. */
  private reach = -1;
  private isSearching = false;
  private isDisposed = false;

  /**
   * Updates the list. Memory is allocated only for a larger texture, now and then, and for requests to the worker.
   *
   * @param eye the eye in object space; for an orthographic camera w is 0 and xyz the unit direction to it
   * @param bounds the bounding sphere, in object space; from inside the sphere there is no list
   * @returns whether the list is valid for this eye. If not, every primitive must be tested.
   */
  update(data: OutlineData, eye: Vector4, bounds: Sphere): boolean {
    const { center, radius } = bounds;
    // The distance to the sphere, 0 or less inside. Math.hypot or a separate function would leave garbage in every frame.
    const room =
      eye.w === 0 ? 1 : Math.sqrt((eye.x - center.x) ** 2 + (eye.y - center.y) ** 2 + (eye.z - center.z) ** 2) - radius;
    if (!(room > 0)) return false;
    const { isSearchedInWorker, search } = data;
    if (data !== this.data) {
      // The mesh has another geometry now.
      this.data = data;
      this.reach = -1;
    }
    const moved = eyeDistance(this.eye, eye);
    if (moved <= (isSearchedInWorker ? 0.5 : 1) * this.reach) return true;
    if (isSearchedInWorker) {
      if (search && !this.isSearching) this.searchInWorker(data, search, eye, SINE_IN_WORKER * room);
      return moved <= this.reach;
    }
    this.remember(eye, SINE * room);
    this.fill(search!, findCandidates(search!, this.eye.toArray(), SINE));
    return true;
  }

  dispose(): void {
    this.isDisposed = true;
    this.texture?.dispose();
    this.texture = null;
    this.reach = -1;
  }

  private remember(eye: Vector4, reach: number): void {
    this.eye.copy(eye);
    this.reach = reach;
  }

  private searchInWorker(data: OutlineData, search: ContourSearch, eye: Vector4, reach: number): void {
    const requestedEye = eye.clone();
    const request = { search, eye: eye.toArray(), sine: SINE_IN_WORKER };
    this.isSearching = true;
    data.search = null;
    runTask('searchContours', request, { createWorker: data.createWorker })
      .then(({ search: returned, count }) => {
        data.search = returned;
        if (this.isDisposed || this.data !== data) return;
        this.remember(requestedEye, reach);
        this.fill(returned, count);
      })
      .catch(() => {
        // The worker has died and the arrays are lost. Until there is a new list, every primitive is tested, so no outline is missing.
        if (this.data === data) this.reach = -1;
        data.restoreSearch();
      })
      .finally(() => {
        this.isSearching = false;
      });
  }

  private fill({ list }: ContourSearch, count: number): void {
    this.count = count;
    const texture = this.textureFor(count);
    const words = texture.image.data as Uint32Array;
    words.set(list.length === count ? list : list.subarray(0, count));
    texture.needsUpdate = true;
  }

  private textureFor(count: number): DataTexture {
    if (this.texture && (this.texture.image.data as Uint32Array).length >= count) return this.texture;
    this.texture?.dispose();
    const { width, height } = pullTextureSize(Math.max(1, Math.ceil((GROWTH * count) / 4)));
    const words = new Uint32Array(4 * width * height);
    this.texture = new DataTexture(words, width, height, RGBAIntegerFormat, UnsignedIntType);
    return this.texture;
  }
}

/** The distance that an eye has moved; infinite between cameras of different kinds. `Math.hypot` would leave garbage in every frame. */
export function eyeDistance(a: Vector4, b: Vector4): number {
  if (a.w !== b.w) return Infinity;
  const x = a.x - b.x;
  const y = a.y - b.y;
  const z = a.z - b.z;
  return Math.sqrt(x * x + y * y + z * z);
}
