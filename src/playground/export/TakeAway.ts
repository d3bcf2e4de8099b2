import type { GeometryLoader } from '../loading/GeometryLoader.js';
import type { PageAddress } from '../session/PageAddress.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { Status } from '../tasks/Status.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { CodeDialog } from './CodeDialog.js';
import { copyPicture } from './copyPicture.js';
import type { ExportActions } from './ExportActions.js';

/** The actions of {@link ExportActions} that buttons run. */
type Action = 'savePng' | 'saveSvg' | 'saveDrawing' | 'saveVideo' | 'saveMap' | 'share' | 'copyLink' | 'copyFacts';

/** The ways in which the user takes the drawing away. The scripts for them are fetched when they are first used. */
export class TakeAway {
  private readonly actions: LaterPart<ExportActions>;
  private readonly codeDialog: LaterPart<CodeDialog>;

  constructor(
    session: Session,
    address: PageAddress,
    private readonly status: Status,
    tasks: TaskRunner,
    geometries: GeometryLoader,
    parts: LaterParts,
  ) {
    this.actions = parts.later(async () => {
      const { ExportActions } = await import('./ExportActions.js');
      return new ExportActions(session, address, status, tasks, geometries);
    });
    this.codeDialog = parts.later(async () => {
      const { CodeDialog } = await import('./CodeDialog.js');
      return new CodeDialog(session);
    });
  }

  /** Saves or hands on the drawing in one of several ways. */
  run(action: Action): void {
    this.actions.use((actions) => void actions[action]());
  }

  /** Puts the picture on the clipboard. To be called while a click is handled. */
  copy(): void {
    // Shows it in the status line if the script cannot be fetched.
    this.actions.use(() => {});
    void copyPicture(() => this.actions.fetch().then((actions) => actions.drawPicture()), this.status);
  }

  openCode(): void {
    this.codeDialog.use((dialog) => dialog.open());
  }
}
