import type { Report } from '../drawing/Report.js';
import { errorMessage } from '../files/errorMessage.js';
import { ModelError } from '../files/ModelError.js';
import type { Status } from './Status.js';

type Slot = 'model' | 'map' | 'occlusion';
type TaskEnd = 'done' | 'failed' | 'replaced';

/**
 * Runs the page's long tasks, at most one for the model, one for the map and one for occlusion. The status line shows them and can cancel
 * them.
 */
export class TaskRunner {
  private readonly running = new Map<
    Slot,
    { controller: AbortController; stage: string; progress: number | undefined }
  >();

  constructor(
    private readonly status: Status,
    private readonly onIdle: () => void,
  ) {}

  get isIdle(): boolean {
    return this.running.size === 0;
  }

  /**
   * Runs a task. One that is still running in the same slot is aborted. Failures are shown in the status line.
   *
   * @returns how it ended: `replaced` if a later task took its slot, `failed` also if the user cancelled it
   */
  async run(slot: Slot, task: (report: Report, signal: AbortSignal) => Promise<void>): Promise<TaskEnd> {
    this.running.get(slot)?.controller.abort();
    const controller = new AbortController();
    const entry = { controller, stage: 'starting', progress: undefined as number | undefined };
    this.running.set(slot, entry);
    const report: Report = (stage, progress) => {
      if (controller.signal.aborted) return;
      Object.assign(entry, { stage, progress });
      this.show();
    };
    let failure: string | undefined;
    let finished = false;
    try {
      await task(report, controller.signal);
      finished = !controller.signal.aborted;
    } catch (error) {
      if (!controller.signal.aborted) failure = sentenceFor(error);
    }
    const isLatest = this.running.get(slot) === entry;
    if (isLatest) this.running.delete(slot);
    if (failure !== undefined) this.status.fail(failure);
    else if (isLatest && controller.signal.aborted) this.status.say('Cancelled; the drawing is as it was.');
    this.show();
    if (this.isIdle) this.onIdle();
    if (!isLatest) return 'replaced';
    return finished ? 'done' : 'failed';
  }

  private show(): void {
    const entry = this.running.get('model') ?? this.running.get('map') ?? this.running.get('occlusion');
    if (!entry) this.status.idle();
    else this.status.working(entry.stage, entry.progress, () => this.cancel());
  }

  private cancel(): void {
    for (const { controller } of this.running.values()) controller.abort();
  }
}

function sentenceFor(error: unknown): string {
  if (error instanceof ModelError) return error.message;
  return `That did not work: ${errorMessage(error)}`;
}
