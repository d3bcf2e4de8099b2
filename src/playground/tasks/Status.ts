import { errorMessage, ModelError, shownText } from '../../viewer/files/common/ModelError.js';

/** An action that solves a problem or continues a result. */
export interface Remedy {
  /** The label of the button. */
  label: string;
  run: () => void;
}

interface Problem {
  sentence: string;
  remedy: Remedy | undefined;
}

/** The status line, with a progress bar, a Cancel button, and a button for a remedy. */
export class Status {
  private cancelTask: (() => void) | undefined;
  /** The cancelling function of the task that was shown last; it identifies the task. */
  private shownTask: (() => void) | undefined;
  private clearTimer: ReturnType<typeof setTimeout> | undefined;
  /** Whether a message is shown that only a task of the user, a problem or another message may replace. */
  private isSaying = false;
  /** The problems of the page by subject, latest last. */
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
   * Shows the step of a task, or an unsolved problem. A message from during the task stays for its seconds.
   *
   * @param progress in [0, 1], or undefined if it is unknown
   * @param cancel the same function as long as it is the same task
   * @param isByItself whether the page has started the task by itself: then earlier messages stay too
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

  /** Ends progress when no task is running any more. A message about the last task stays. */
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

  /** Shows a message with a button for a further action, until the next message, or until the user starts a task. */
  offer(sentence: string, more: Remedy): void {
    this.finish();
    this.write(sentence, false, more);
    this.isSaying = true;
  }

  /**
   * Shows a problem until it is solved: it stays while other tasks run, and returns after a message. Only a problem with a remedy, or a
   * later one, has precedence.
   *
   * @param about the subject, which has one problem at most
   * @param remedy offered while no task runs
   */
  addProblem(about: string, sentence: string, remedy?: Remedy): void {
    this.problems.delete(about);
    this.problems.set(about, { sentence, remedy });
    this.rest();
  }

  /** Removes a solved problem. @param news a message that is shown if there are no other problems */
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

  /** Shows the latest problem with a remedy, or else the latest, or else `text`. */
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
    // Written only when it changes, because screen readers would read it again.
    if (message.textContent !== text) message.textContent = text;
  }
}

/** The messages of Chromium, Firefox and Safari for a failed dynamic import. */
const MISSING_SCRIPT = /dynamically imported module|importing a module script/i;

/** Describes an error for the status line. */
export function sentenceFor(error: unknown): string {
  if (error instanceof ModelError) return error.message;
  const message = errorMessage(error);
  if (MISSING_SCRIPT.test(message)) {
    return 'A part of this page could not be fetched. Check the connection and reload the page.';
  }
  return `That did not work: ${message}`;
}
