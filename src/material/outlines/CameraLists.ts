import type { Camera } from 'three';
import type { ContourList } from './ContourList.js';
import type { InstanceList } from './InstanceList.js';

/** The largest number of lists that are kept, one per camera: more than the six cameras of a CubeCamera and two eyes. */
const MAX_LISTS = 12;

/** The list of each camera of what may hold an outline. */
export class CameraLists {
  private readonly lists = new Map<Camera, ContourList | InstanceList>();

  /** The list of a camera. If there are too many, the oldest one is removed, since its camera may be gone. */
  of<List extends ContourList | InstanceList>(camera: Camera, Kind: new () => List): List {
    const known = this.lists.get(camera);
    if (known instanceof Kind) return known;
    known?.dispose();
    if (this.lists.size >= MAX_LISTS && known === undefined) {
      const [oldest] = this.lists;
      oldest[1].dispose();
      this.lists.delete(oldest[0]);
    }
    const list = new Kind();
    this.lists.set(camera, list);
    return list;
  }

  dispose(): void {
    for (const list of this.lists.values()) list.dispose();
    this.lists.clear();
  }
}
