const WIDTH = 30;

/** A line that fills from left to right; on what is no terminal, a log for example, it says nothing. */
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

  /** Takes the line away. */
  clear(): void {
    if (this.shown >= 0) this.stream.write('\r\x1b[K');
  }
}
