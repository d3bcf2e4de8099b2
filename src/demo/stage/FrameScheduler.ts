/** Draws when asked to, at most once per screen refresh. An idle page draws nothing. */
export class FrameScheduler {
  /** Frames drawn since the start. */
  frames = 0;
  private request = 0;

  constructor(private readonly draw: () => void) {}

  /** Asks for one frame; asking again before it is drawn changes nothing. */
  invalidate(): void {
    this.request ||= requestAnimationFrame(this.onFrame);
  }

  /** Whether a frame was asked for that is not drawn yet. */
  get isWaiting(): boolean {
    return this.request !== 0;
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
  }

  private readonly onFrame = (): void => {
    this.request = 0;
    this.frames++;
    this.draw();
  };
}
