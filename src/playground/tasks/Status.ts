import { shownText } from '../../viewer/files/common/shownText.js';

/** An action that solves a problem, or does more than was done. */
export interface Remedy {
  /** The label of the button. */
  label: string;
  run: () => void;
}

interface Problem {
  sentence: string;
  remedy: Remedy | undefined;
}

/** The status line, with a progress bar, a button that cancels the task, and one that solves a problem. */
export class Status {
  private cancelTask: (() => void) | undefined;
  /** The task whose viewport was shown last, by the function that cancels it. */
  private shownTask: (() => void) | undefined;
  private clearTimer: ReturnType<typeof setTimeout> | undefined;
  /** Whether a message is shown that only a task which the user starts, a problem or another message may replace. */
  private isSaying = false;
  /** The problems of the page by their subject, the latest last. */
  private readonly problems = new Map<string, Problem>();
  private remedy: Remedy | undefined;

  constructor(
    private readonly elements: {
      message: HTMLElement;
      progress: HTMLElement;
      progressLine: HTMLElement;
      cancel: HTMLButtonElement;
      mend: HTMLButtonElement;
    },
  ) {
    elements.cancel.addEventListener('click', () => this.cancelTask?.());
    elements.mend.addEventListener('click', () => this.remedy?.run());
  }

  /**
   * Shows the viewport of a task, or a problem that is not solved. A message that was said during the task stays for its seconds.
   *
   * @param progress in [0, 1], or undefined if it is unknown
   * @param cancel the same function as long as it is the same task
   * @param isByItself whether the page has started the task without being asked: then messages said before it stay too
   */
  working(viewport: string, progress: number | undefined, cancel: () => void, isByItself = false): void {
    const isSameTask = cancel === this.shownTask;
    this.shownTask = cancel;
    this.cancelTask = cancel;
    if (!this.isSaying || !(isSameTask || isByItself))
      this.rest(`${viewport.charAt(0).toUpperCase()}${viewport.slice(1)}…`);
    const { progress: bar, progressLine, cancel: button } = this.elements;
    bar.hidden = false;
    button.hidden = false;
    progressLine.style.transform = `scaleX(${progress ?? 0.04})`;
  }

  /** No task is running any more. A message on how the last one ended stays. */
  idle(): void {
    const wasWorking = this.cancelTask !== undefined;
    this.finish();
    if (wasWorking && !this.isSaying) this.rest();
  }

  /** Shows an error until the next message, or until the user starts a task. */
  fail(sentence: string): void {
    this.finish();
    this.write(sentence, true);
    this.isSaying = true;
  }

  /** Shows a message for a few seconds. */
  say(sentence: string): void {
    this.finish();
    this.write(sentence, false);
    this.isSaying = true;
    this.clearTimer = setTimeout(() => this.rest(), 6000);
  }

  /** Shows a message with a button that does something more, until the next message, or until the user starts a task. */
  offer(sentence: string, more: Remedy): void {
    this.finish();
    this.write(sentence, false, more);
    this.isSaying = true;
  }

  /**
   * Shows a problem until it is solved: other tasks that go on do not hide it, and it comes back after a message. Only one with a remedy lies over
   * it, or a later one.
   *
   * @param about the subject, which has one problem at most
   * @param remedy offered as long as no task runs
   */
  addProblem(about: string, sentence: string, remedy?: Remedy): void {
    this.problems.delete(about);
    this.problems.set(about, { sentence, remedy });
    this.rest();
  }

  /** Removes a problem, because it is solved. @param news a message that is shown if there are no other problems */
  solveProblem(about: string, news?: string): void {
    if (!this.problems.delete(about)) return;
    if (news && this.problems.size === 0) this.say(news);
    else this.rest();
  }

  private finish(): void {
    this.cancelTask = undefined;
    this.elements.progress.hidden = true;
    this.elements.cancel.hidden = true;
  }

  /** Shows the latest problem of those with a remedy, or else of all, or `text` if there is none. */
  private rest(text = ''): void {
    const problems = [...this.problems.values()];
    const problem = problems.findLast(({ remedy }) => remedy) ?? problems.at(-1);
    this.write(problem?.sentence ?? text, problem !== undefined, problem?.remedy);
  }

  private write(sentence: string, isError: boolean, remedy?: Remedy): void {
    clearTimeout(this.clearTimer);
    this.isSaying = false;
    // Messages of readers and of the browser may contain text from a file.
    const text = shownText(sentence);
    const { message, mend } = this.elements;
    this.remedy = remedy;
    mend.hidden = !remedy || this.cancelTask !== undefined;
    mend.textContent = remedy?.label ?? '';
    message.classList.toggle('is-error', isError);
    // The text is written only when it changes, because screen readers would read it again.
    if (message.textContent !== text) message.textContent = text;
  }
}
