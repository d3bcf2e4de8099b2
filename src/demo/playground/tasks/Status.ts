import { shownText } from '../../files/common/shownText.js';

/** What users can do about a problem. */
export interface Remedy {
  /** Of the button. */
  label: string;
  run: () => void;
}

interface Problem {
  sentence: string;
  remedy: Remedy | undefined;
}

/** The status line, with a progress bar, a button that cancels the task, and one that mends a problem. */
export class Status {
  private cancelTask: (() => void) | undefined;
  /** The task whose stage was shown last, by the function that cancels it. */
  private shownTask: (() => void) | undefined;
  private clearTimer: ReturnType<typeof setTimeout> | undefined;
  /** Whether a message is shown that only a task which the user starts, a problem or another message may replace. */
  private isSaying = false;
  /** What is wrong with the page, by what it is about; the latest last. */
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
   * Shows the stage of a task, or a problem that is not solved. A message that was said during the task stays for its seconds.
   *
   * @param progress in [0, 1], or undefined if it is unknown
   * @param cancel the same function as long as it is the same task
   * @param isByItself whether the page has started the task without being asked: then messages said before it stay too
   */
  working(stage: string, progress: number | undefined, cancel: () => void, isByItself = false): void {
    const isSameTask = cancel === this.shownTask;
    this.shownTask = cancel;
    this.cancelTask = cancel;
    if (!this.isSaying || !(isSameTask || isByItself)) this.rest(`${stage.charAt(0).toUpperCase()}${stage.slice(1)}…`);
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

  /** Shows an error, until the next message. */
  fail(sentence: string): void {
    this.finish();
    this.write(sentence, true);
  }

  /** Shows a message for a few seconds. */
  say(sentence: string): void {
    this.finish();
    this.write(sentence, false);
    this.isSaying = true;
    this.clearTimer = setTimeout(() => this.rest(), 6000);
  }

  /**
   * Shows a problem until it is solved: other tasks that go on do not hide it, and it comes back after a message.
   *
   * @param about what it is about. There is one problem at most about each thing.
   * @param remedy offered as long as no task runs
   */
  addProblem(about: string, sentence: string, remedy?: Remedy): void {
    this.problems.delete(about);
    this.problems.set(about, { sentence, remedy });
    this.write(sentence, true, remedy);
  }

  /** The problem about something is solved. @param news said of it where nothing else is wrong */
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

  /** Shows the latest problem, or, if there is none, the text. */
  private rest(text = ''): void {
    const problem = [...this.problems.values()].at(-1);
    this.write(problem?.sentence ?? text, problem !== undefined, problem?.remedy);
  }

  private write(sentence: string, isError: boolean, remedy?: Remedy): void {
    clearTimeout(this.clearTimer);
    this.isSaying = false;
    // What a reader or the browser says may hold words of a file.
    const text = shownText(sentence);
    const { message, mend } = this.elements;
    this.remedy = remedy;
    mend.hidden = !remedy || this.cancelTask !== undefined;
    mend.textContent = remedy?.label ?? '';
    message.classList.toggle('is-error', isError);
    // Written only when it changes, because screen readers would read it again.
    if (message.textContent !== text) message.textContent = text;
  }
}
