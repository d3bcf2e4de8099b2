import { shownText } from '../files/shownText.js';

/** The status line, with a progress bar and a button that cancels the task. */
export class Status {
  private cancelTask: (() => void) | undefined;
  private clearTimer: ReturnType<typeof setTimeout> | undefined;
  /** What is wrong with the page, by what it is about; the latest last. */
  private readonly problems = new Map<string, string>();

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

  /** Shows the stage of a task, or a problem that is not solved. `progress` is in [0, 1], or undefined if it is unknown. */
  working(stage: string, progress: number | undefined, cancel: () => void): void {
    this.cancelTask = cancel;
    this.rest(`${stage.charAt(0).toUpperCase()}${stage.slice(1)}…`);
    const { progress: bar, progressLine, cancel: button } = this.elements;
    bar.hidden = false;
    button.hidden = false;
    progressLine.style.transform = `scaleX(${progress ?? 0.04})`;
  }

  /** No task is running any more. A message on how the last one ended stays. */
  idle(): void {
    const wasWorking = this.cancelTask !== undefined;
    this.finish();
    if (wasWorking) this.rest();
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
    this.clearTimer = setTimeout(() => this.rest(), 6000);
  }

  /**
   * Shows a problem until it is solved: other tasks that go on do not hide it, and it comes back after a message.
   *
   * @param about what it is about. There is one problem at most about each thing.
   */
  addProblem(about: string, sentence: string): void {
    this.problems.delete(about);
    this.problems.set(about, sentence);
    this.write(sentence, true);
  }

  /** The problem about something is solved. */
  solveProblem(about: string): void {
    if (this.problems.delete(about)) this.rest();
  }

  private finish(): void {
    this.cancelTask = undefined;
    this.elements.progress.hidden = true;
    this.elements.cancel.hidden = true;
  }

  /** Shows the latest problem, or, if there is none, the text. */
  private rest(text = ''): void {
    const problem = [...this.problems.values()].at(-1);
    this.write(problem ?? text, problem !== undefined);
  }

  private write(sentence: string, isError: boolean): void {
    clearTimeout(this.clearTimer);
    // What a reader or the browser says may hold words of a file.
    const text = shownText(sentence);
    const { message } = this.elements;
    message.classList.toggle('is-error', isError);
    // Written only when it changes, because screen readers would read it again.
    if (message.textContent !== text) message.textContent = text;
  }
}
