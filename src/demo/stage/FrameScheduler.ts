/** Calls for frames on demand, at most once per refresh of the screen. An idle page draws no frames. */
export class FrameScheduler {
  /** Number of frames drawn so far. */
  frames = 0;
  private request = 0;

  constructor(private readonly draw: () => void) {}

  /** Requests one frame. Further requests before it is drawn have no effect. */
  invalidate(): void {
    this.request ||= requestAnimationFrame(this.onFrame);
  }

  /** Whether a frame was requested and is not drawn yet. */
  get isWaiting(): boolean {
    return this.request !== 0;
  }

  private readonly onFrame = (): void => {
    this.request = 0;
    this.frames++;
    this.draw();
  };
}
