/** The status line, with a progress bar and a button that cancels the task. */
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

  /** Shows the stage of a task. `progress` is in [0, 1], or undefined if it is unknown. */
  working(stage: string, progress: number | undefined, cancel: () => void): void {
    this.cancelTask = cancel;
    this.write(`${stage.charAt(0).toUpperCase()}${stage.slice(1)}…`, false);
    const { progress: bar, progressLine, cancel: button } = this.elements;
    bar.hidden = false;
    button.hidden = false;
    progressLine.style.transform = `scaleX(${progress ?? 0.04})`;
  }

  /** No task is running any more. A message on how the last one ended stays. */
  idle(): void {
    const wasWorking = this.cancelTask !== undefined;
    this.finish();
    if (wasWorking) this.write('', false);
  }

  /** Shows an error, until the next message. */
  fail(sentence: string): void {
    this.finish();
    this.write(sentence, true);
  }

  /** Shows a message for a few seconds. */
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
    // Written only when it changes, because screen readers would read it again.
    if (message.textContent !== text) message.textContent = text;
  }
}
