const WIDTH = 30;

/** A progress bar in a terminal. Prints nothing to streams that are no terminals, such as logs. */
export class ProgressBar {
  private shown = -1;

  constructor(private readonly stream: NodeJS.WriteStream) {}

  /** @param progress in [0, 1] */
  show(stage: string, progress: number): void {
    const percent = Math.floor(100 * progress);
    if (!this.stream.isTTY || percent === this.shown) return;
    this.shown = percent;
    const filled = Math.round(WIDTH * progress);
    this.stream.write(
      `\r${'█'.repeat(filled)}${'░'.repeat(WIDTH - filled)} ${String(percent).padStart(3)} % ${stage}\x1b[K`,
    );
  }

  /** Erases the line. */
  clear(): void {
    if (this.shown >= 0) this.stream.write('\r\x1b[K');
  }
}
