import {
  type Camera,
  Frustum,
  type Material,
  Matrix4,
  type Mesh,
  type Object3D,
  type Scene,
  type WebGLRenderer,
} from 'three';
import { FrameStamp } from '../FrameStamp.js';
import type { IntersectingOutlines } from './IntersectingOutlines.js';
import { type NumberedPart, numberParts } from './NumberedPart.js';

/** Outlines that can be drawn. */
export type DrawnOutlines = IntersectingOutlines & Object3D & { readonly geometry: Mesh['geometry'] };

/** How a renderer draws lines between parts that move: a map that holds the part and the plane that each pixel shows, and lines from it. */
export interface LineDrawer {
  /** Draws the map of the parts that have a look and are not seen through. @param outlines those whose draw it interrupts */
  drawMap(parts: readonly NumberedPart[], outlines: DrawnOutlines, scene: Scene, camera: Camera): void;
  /** Draws the lines of the material of outlines over the view. @param look its number in this frame */
  drawLines(outlines: DrawnOutlines, look: number, scene: Scene, camera: Camera): void;
  /** Draws, on a part that is seen through, the lines where it meets those of the map. */
  drawClear(part: NumberedPart, outlines: DrawnOutlines, scene: Scene, camera: Camera): void;
  /** Frees all that was made; a later frame makes it anew. */
  free(): void;
}

/** Frames without movement after which the map is freed. */
const KEPT_FRAMES = 60;
/** Vertices of the triangle that covers the screen. */
export const SCREEN_VERTICES = 3;

const frustum = /* @__PURE__ */ new Frustum();
const matrix = /* @__PURE__ */ new Matrix4();

/** The lines between parts that move, on the screen of one renderer. */
export class ScreenLines {
  private readonly frame = new FrameStamp();
  private isMapped = false;
  private restingFrames = 0;
  /** The outline materials of the frame, and which of them have been drawn. */
  private readonly looks: Material[] = [];
  private readonly isDrawn: boolean[] = [];

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly drawer: LineDrawer,
  ) {}

  /**
   * Draws the lines of the material of outlines, once for each camera in a frame, and those on a part that is seen through. Allocates nothing
   * while the same parts move.
   *
   * @param part the part of the outlines
   * @param root the scene of the parts
   */
  draw(
    outlines: DrawnOutlines,
    part: NumberedPart | undefined,
    parts: readonly NumberedPart[],
    root: Object3D,
    scene: Scene,
    camera: Camera,
  ): void {
    if (!this.frame.isOf(this.renderer, camera)) {
      this.frame.note(this.renderer, camera);
      this.isMapped = this.findMoving(parts, root, camera);
      if (this.isMapped) this.drawer.drawMap(parts, outlines, scene, camera);
    }
    if (!this.isMapped) return;
    const look = this.looks.indexOf(outlines.material);
    if (look >= 0 && !this.isDrawn[look]) {
      this.isDrawn[look] = true;
      this.drawer.drawLines(outlines, look + 1, scene, camera);
    }
    if (part?.isClear && part.look > 0) this.drawer.drawClear(part, outlines, scene, camera);
  }

  /** Gives each part in view the number of its look. Returns whether parts have moved against each other. */
  private findMoving(parts: readonly NumberedPart[], root: Object3D, camera: Camera): boolean {
    if (this.renderer.xr.isPresenting) return false;
    if (numberParts(parts, root) < 2) {
      if (++this.restingFrames === KEPT_FRAMES) this.drawer.free();
      return false;
    }
    this.restingFrames = 0;
    this.looks.length = this.isDrawn.length = 0;
    matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const { coordinateSystem, reversedDepth } = camera as Camera & { reversedDepth?: boolean };
    frustum.setFromProjectionMatrix(matrix, coordinateSystem, reversedDepth);
    for (let i = 0; i < parts.length; i++) {
      const part = parts[i];
      const { mesh, material } = part.outlines;
      // WebGLRenderer may not have uploaded what lies outside.
      const isInView = part.number > 0 && mesh!.layers.test(camera.layers) && frustum.intersectsObject(mesh!);
      part.look = isInView ? this.lookOf(material) : 0;
    }
    return true;
  }

  /** The number of an outline material in this frame, from 1. */
  private lookOf(material: Material): number {
    const known = this.looks.indexOf(material);
    if (known >= 0) return known + 1;
    this.isDrawn.push(false);
    return this.looks.push(material);
  }
}
