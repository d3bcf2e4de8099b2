import type { GeometryLoader } from '../loading/GeometryLoader.js';
import type { PageAddress } from '../session/PageAddress.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { Status } from '../tasks/Status.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { CodeDialog } from './CodeDialog.js';
import type { ExportActions } from './ExportActions.js';

/**
 * Copies a picture to the clipboard, and tells the user whether that was possible. To be called while a click is handled: the clipboard
 * gets a promise at once, because some browsers, such as Safari, refuse later requests.
 *
 * @param draw draws the picture as PNG. If it rejects, the user has been told why
 */
async function copyPicture(draw: () => Promise<Blob>, status: Status): Promise<void> {
  const refuse = (): void =>
    status.fail('The browser does not let this page use the clipboard: save the picture instead.');
  if (!navigator.clipboard?.write || typeof ClipboardItem === 'undefined') {
    refuse();
    return;
  }
  const picture = draw();
  const [drawn, copied] = await Promise.allSettled([picture, write(picture)]);
  if (drawn.status === 'rejected') return;
  if (copied.status === 'rejected') refuse();
  else status.say('The picture is on the clipboard, as PNG.');
}

/** Rejects where older browsers throw, which do not take promises. */
const write = async (picture: Promise<Blob>): Promise<void> =>
  navigator.clipboard.write([new ClipboardItem({ 'image/png': picture })]);

/** The actions of {@link ExportActions} that buttons run. */
type Action = 'savePng' | 'saveSvg' | 'saveDrawing' | 'saveVideo' | 'saveMap' | 'share' | 'copyLink' | 'copyFacts';

/** The ways in which the user takes the drawing away. The scripts for them are fetched when they are first used. */
export class Exports {
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
