import type { Report } from '../../viewer/drawing/buildModel.js';
import { LostContextError } from '../viewport/ContextLoss.js';
import type { Remedy, Status } from './Status.js';
import { sentenceFor } from './Status.js';

type Slot = 'model' | 'map' | 'form' | 'occlusion' | 'picture';
type TaskEnd = 'done' | 'failed' | 'replaced';

/**
 * Runs the page's long tasks, at most one per slot: model, map, form lines, occlusion and saved picture. The status line shows them and can
 * cancel them.
 */
export class TaskRunner {
  private readonly running = new Map<
    Slot,
    { controller: AbortController; stage: string; progress: number | undefined; cancel: () => void }
  >();
  /** Functions called when a task has ended. */
  private readonly waiting = new Set<() => void>();

  constructor(
    private readonly status: Status,
    private readonly page: {
      /** Whether there is a drawing. Without one, a failure is shown until it is solved. */
      hasDrawing(): boolean;
      /** Called when the last task has ended. */
      onIdle(): void;
    },
  ) {}

  get isIdle(): boolean {
    return this.running.size === 0;
  }

  isRunning(slot: Slot): boolean {
    return this.running.has(slot);
  }

  /**
   * For a background task: resolves when all other tasks have ended, or when the task itself is aborted. Undefined if there are no other
   * tasks.
   */
  others(slot: Slot, signal: AbortSignal): Promise<void> | undefined {
    return this.until(() => [...this.running.keys()].every((running) => running === slot), signal);
  }

  /**
   * Resolves when the task in a slot has ended, for a task that needs its result, or when that one is aborted. Undefined if it is not
   * running.
   */
  ended(slot: Slot, signal: AbortSignal): Promise<void> | undefined {
    return this.until(() => !this.running.has(slot), signal);
  }

  /**
   * Runs a task. A running task in the same slot is aborted. A failure is shown in the status line until the task is run again or, if there
   * is a drawing anyway, until any task is run.
   *
   * @param again offered if the task failed because the graphics context was lost, so that it may succeed the next time
   * @returns the result: `replaced` if a later task took its slot, `failed` also if the user cancelled it
   */
  async run(
    slot: Slot,
    task: (report: Report, signal: AbortSignal) => Promise<void>,
    again?: Remedy,
  ): Promise<TaskEnd> {
    const { status, page } = this;
    this.running.get(slot)?.controller.abort();
    // The page bakes occlusion by itself, so an earlier failure on the status line still matters.
    if (slot !== 'occlusion' && page.hasDrawing()) for (const about of SLOTS) status.solveProblem(about);
    status.solveProblem(slot);
    const controller = new AbortController();
    const entry = {
      controller,
      stage: 'starting',
      progress: undefined as number | undefined,
      cancel: () => this.cancel(),
    };
    this.running.set(slot, entry);
    const report: Report = (stage, progress) => {
      if (controller.signal.aborted) return;
      Object.assign(entry, { stage, progress });
      this.show();
    };
    let failure: unknown;
    let finished = false;
    try {
      await task(report, controller.signal);
      finished = !controller.signal.aborted;
    } catch (error) {
      if (!controller.signal.aborted) failure = error;
    }
    const isLatest = this.running.get(slot) === entry;
    if (isLatest) this.running.delete(slot);
    for (const check of [...this.waiting]) check();
    if (failure !== undefined)
      status.addProblem(slot, sentenceFor(failure), failure instanceof LostContextError ? again : undefined);
    else if (isLatest && controller.signal.aborted) this.sayCancelled(slot);
    this.show();
    if (this.isIdle) page.onIdle();
    if (!isLatest) return 'replaced';
    return finished ? 'done' : 'failed';
  }

  /** Stops an obsolete task without a message. */
  stop(slot: Slot): void {
    this.running.get(slot)?.controller.abort();
    if (!this.running.delete(slot)) return;
    for (const check of [...this.waiting]) check();
    this.show();
  }

  /** Resolves when a condition on the running tasks holds, or when the waiting task is aborted. Undefined if it holds now. */
  private until(isReached: () => boolean, signal: AbortSignal): Promise<void> | undefined {
    const isOver = (): boolean => signal.aborted || isReached();
    if (isOver()) return undefined;
    return new Promise((resolve) => {
      const check = (): void => {
        if (!isOver()) return;
        this.waiting.delete(check);
        signal.removeEventListener('abort', check);
        resolve();
      };
      this.waiting.add(check);
      signal.addEventListener('abort', check);
    });
  }

  private sayCancelled(slot: Slot): void {
    if (this.page.hasDrawing()) this.status.say('Cancelled; the drawing is as it was.');
    else this.status.addProblem(slot, 'Cancelled, so there is no drawing yet: choose a model, or reload the page.');
  }

  private show(): void {
    const slot = SLOTS.find((candidate) => this.running.has(candidate));
    const entry = slot && this.running.get(slot);
    if (!entry) this.status.idle();
    else this.status.working(entry.stage, entry.progress, entry.cancel, slot === 'occlusion');
  }

  private cancel(): void {
    for (const { controller } of this.running.values()) controller.abort();
  }
}

const SLOTS: readonly Slot[] = ['model', 'map', 'form', 'occlusion', 'picture'];
