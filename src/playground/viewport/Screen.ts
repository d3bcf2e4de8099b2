/** Size of a frame in CSS pixels, and device pixels per CSS pixel. */
export interface FrameSize {
  width: number;
  height: number;
  ratio: number;
}

/** Draws frames with another renderer, on its own canvas over the painter's. */
export interface Screen {
  readonly canvas: HTMLCanvasElement;
  /** Whether its renderer supports the present look. If not, the painter draws. */
  readonly canDraw: boolean;
  /** True while programs compile, also for the first frame. A frame is requested when they are ready. */
  readonly isBuilding: boolean;
  /** Whether a frame can be drawn now. If not, starts building what it needs; a frame is requested afterwards. */
  prepare(): boolean;
  draw(size: FrameSize): void;
  dispose(): void;
}
