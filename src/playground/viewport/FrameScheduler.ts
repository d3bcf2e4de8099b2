/** Calls for frames on demand, at most once per refresh of the screen. An idle page draws no frames. */
export class FrameScheduler {
  /** Number of frames drawn so far. */
  frames = 0;
  private request = 0;

  /**
   * @param draw draws a frame
   * @param mustWait whether a frame that was requested has to wait: it is asked for anew with the next refresh
   */
  constructor(
    private readonly draw: () => void,
    private readonly mustWait: () => boolean = () => false,
  ) {}

  /** Requests one frame. Further requests before it is drawn have no effect. */
  invalidate(): void {
    this.request ||= requestAnimationFrame(this.onFrame);
  }

  /** Whether a frame was requested and is not drawn yet. */
  get isWaiting(): boolean {
    return this.request !== 0;
  }

  private readonly onFrame = (): void => {
    if (this.mustWait()) {
      this.request = requestAnimationFrame(this.onFrame);
      return;
    }
    this.request = 0;
    this.frames++;
    this.draw();
  };
}
