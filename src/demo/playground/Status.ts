/** The line that says in words what is going on, with a thin line for how far it is and a way to call it off. */
export class Status {
  private cancelTask: (() => void) | undefined;
  private clearTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly elements: {
      message: HTMLElement;
      progress: HTMLElement;
      progressLine: HTMLElement;
      cancel: HTMLButtonElement;
    },
  ) {
    elements.cancel.addEventListener('click', () => this.cancelTask?.());
  }

  /** A task is at `stage`; `progress` is in [0, 1], or undefined while it is unknown. */
  working(stage: string, progress: number | undefined, cancel: () => void): void {
    this.cancelTask = cancel;
    this.write(`${stage.charAt(0).toUpperCase()}${stage.slice(1)}…`, false);
    const { progress: bar, progressLine, cancel: button } = this.elements;
    bar.hidden = false;
    button.hidden = false;
    progressLine.style.transform = `scaleX(${progress ?? 0.04})`;
  }

  /** Nothing is going on any more. What has been said of how it ended stays. */
  idle(): void {
    const wasWorking = this.cancelTask !== undefined;
    this.finish();
    if (wasWorking) this.write('', false);
  }

  /** Something failed: the sentence stays until the next thing happens. */
  fail(sentence: string): void {
    this.finish();
    this.write(sentence, true);
  }

  /** Something was done; said for a moment. */
  say(sentence: string): void {
    this.finish();
    this.write(sentence, false);
    this.clearTimer = setTimeout(() => this.write('', false), 6000);
  }

  private finish(): void {
    this.cancelTask = undefined;
    this.elements.progress.hidden = true;
    this.elements.cancel.hidden = true;
  }

  private write(text: string, isError: boolean): void {
    clearTimeout(this.clearTimer);
    const { message } = this.elements;
    message.classList.toggle('is-error', isError);
    // Told again word for word on every step of a progress, a screen reader would never stop.
    if (message.textContent !== text) message.textContent = text;
  }
}
