/** The size of a frame in CSS pixels, and the pixels of the canvas for each of them. */
export interface FrameSize {
  width: number;
  height: number;
  ratio: number;
}

/** Draws frames with another renderer than the painter's, on a canvas of its own that lies over the painter's. */
export interface Screen {
  readonly canvas: HTMLCanvasElement;
  /** Whether its renderer draws all that is shown at present. If not, the painter does. */
  readonly canDraw: boolean;
  /** Whether what frames are drawn with is being built, be it by the first of them. A frame is requested when it is there. */
  readonly isBuilding: boolean;
  /** Whether a frame can be drawn now. If not, what it needs is built, and a frame is requested then. */
  prepare(): boolean;
  draw(size: FrameSize): void;
  dispose(): void;
}
