import { Box3, type Camera, type Object3D, type WebGLRenderer } from 'three';
import { FrameStamp } from '../FrameStamp.js';
import { type SeenBox, seenBox } from './seenDepths.js';

/** The extent of a scene, relative to which `depthFade` measures depth. The materials of a scene share one. */
export class SceneExtent {
  private readonly measured = new FrameStamp();
  private readonly seen: SeenBox = { front: 0, back: 1, left: -1, right: 1, bottom: -1, top: 1 };
  private isSeen = false;

  /**
   * @param frame the object in whose space the box is; the box moves with it
   * @param box the bounding box of everything that is drawn
   */
  constructor(
    readonly frame: Object3D,
    readonly box: Box3 = new Box3(),
  ) {}

  /**
   * The depth range of the box and its place on the sheet in the present frame; null if nothing of it is seen. Measured once per frame;
   * allocates nothing.
   *
   * @internal
   */
  seenFrom(renderer: WebGLRenderer, camera: Camera): Readonly<SeenBox> | null {
    if (!this.measured.isOf(renderer, camera)) {
      this.measured.note(renderer, camera);
      this.isSeen = seenBox(this.box, this.frame.matrixWorld, camera, this.seen);
    }
    return this.isSeen ? this.seen : null;
  }
}
