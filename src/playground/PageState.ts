import { setPageState } from './page/elements.js';
import { page, pageForm } from './page/page.js';
import type { DrawingOpener } from './session/DrawingOpener.js';
import type { Session } from './session/Session.js';
import type { Status } from './tasks/Status.js';
import type { TaskRunner } from './tasks/TaskRunner.js';

/** Shows the state of the page: loading, ready, without a graphics context, or without anything to draw. */
export class PageState {
  private fetchesRest = false;

  /**
   * @param hasLights whether the light handles exist, without which the page is not ready
   * @param isAwaited whether a part of the drawing is still to be baked
   */
  constructor(
    private readonly session: Session,
    private readonly tasks: TaskRunner,
    private readonly opener: DrawingOpener,
    private readonly status: Status,
    hasLights: () => boolean,
    private readonly isAwaited: () => boolean,
  ) {
    const { viewport } = session;
    viewport.frames.onFrame(() => {
      if (!tasks.isIdle || !viewport.isComplete || viewport.frames.isBuilding) return;
      if (hasLights()) setPageState('ready');
      this.fetchRest();
    });
    page.canvas.addEventListener('webglcontextlost', () => this.lose());
    page.canvas.addEventListener('webglcontextrestored', () => this.restore());
  }

  /** Call this when the last task has ended. */
  tasksEnded(): void {
    this.showIfFailed();
    this.session.viewport.frames.refine();
  }

  /** Shows the state `failed` if there is nothing to draw and nothing is loading. */
  showIfFailed(): void {
    const { viewport } = this.session;
    if (this.tasks.isIdle && !this.opener.isOpening && !viewport.isComplete && !viewport.isLost) setPageState('failed');
  }

  /** Fetches the unopened parts of the page, once, after the first drawing is complete, which they would delay. */
  private fetchRest(): void {
    // An embedded page offers few parts to open.
    if (this.fetchesRest || pageForm === 'embed' || this.isAwaited()) return;
    this.fetchesRest = true;
    // A part that fails is fetched again when it is opened.
    import('./fetchRest.js').then(({ fetchRest }) => fetchRest()).catch(() => {});
  }

  private lose(): void {
    const { viewport, mapLoader } = this.session;
    setPageState('lost');
    mapLoader.releaseGraphics();
    this.status.addProblem(
      'context',
      viewport.showsLastPicture
        ? 'The graphics card has let go of the drawing again. This is its last picture; reload the page to go on if it stays.'
        : 'The graphics card has let go of the drawing. It should come back by itself; if not, reload the page.',
    );
  }

  private restore(): void {
    this.status.solveProblem('context', 'The drawing is back.');
    setPageState('loading');
    this.showIfFailed();
    this.session.viewport.frames.invalidate();
  }
}
