import type { ModelChoice } from '../../viewer/settings/shareLink.js';
import { type Status, sentenceFor } from '../tasks/Status.js';
import type { DrawingStore } from './DrawingStore.js';
import type { LinkFollower } from './LinkFollower.js';
import type { PageAddress } from './PageAddress.js';
import type { Session } from './Session.js';

/** Opens drawings asynchronously. The page's address is not written while one is being opened. */
export class DrawingOpener {
  /** Called when opening has ended, successfully or not. */
  onEnd: () => void = () => {};
  private opening = 0;
  /** The script is fetched when the first drawing is opened. */
  private links: LinkFollower | undefined;

  constructor(
    private readonly session: Session,
    private readonly address: PageAddress,
    private readonly store: DrawingStore,
    private readonly status: Status,
  ) {}

  /** Whether a drawing is being opened: the user is being asked, or a stored drawing is being read. */
  get isOpening(): boolean {
    return this.opening > 0;
  }

  /** Opens the drawing of the page's address. */
  readonly follow = (): void => {
    void this.open((links) => links.follow());
  };

  /** Opens a stored drawing. */
  openKept(id: string): Promise<void> {
    return this.open((links) => links.openKept(id));
  }

  /** Opens a model of another site, if the user agrees. @param isFramed whether the model is framed */
  openAddress(address: string, isFramed: boolean, choice: ModelChoice): void {
    void this.open((links) => links.showAddress(address, isFramed, choice));
  }

  private async open(show: (links: LinkFollower) => Promise<void>): Promise<void> {
    const { session, address, store, status } = this;
    this.opening++;
    status.solveProblem('link');
    try {
      const { LinkFollower } = await import('./LinkFollower.js');
      this.links ??= new LinkFollower(session, address, store);
      await show(this.links);
    } catch (error) {
      status.addProblem('link', sentenceFor(error));
    }
    this.opening--;
    if (!this.isOpening) session.modelLoader.showSomething();
    this.onEnd();
  }
}
