import type { GeometryLoader } from '../loading/bakeLoaders.js';
import type { PageAddress } from '../session/PageAddress.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { Status } from '../tasks/Status.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { CodeDialog } from './CodeDialog.js';
import type { ExportActions } from './ExportActions.js';

/**
 * Copies a picture to the clipboard and reports the result. Must be called while a click is handled: the clipboard gets a promise at once,
 * because some browsers, such as Safari, refuse later requests.
 *
 * @param draw draws the picture as PNG; if it rejects, it has reported the reason itself
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

/** Turns the exception of older browsers, which do not accept promises, into a rejection. */
const write = async (picture: Promise<Blob>): Promise<void> =>
  navigator.clipboard.write([new ClipboardItem({ 'image/png': picture })]);

/** The actions of {@link ExportActions} with buttons. */
type Action =
  | 'savePng'
  | 'saveSvg'
  | 'previewPlot'
  | 'saveDrawing'
  | 'saveVideo'
  | 'saveMap'
  | 'share'
  | 'copyLink'
  | 'copyFacts';

/** The exports of the page. Their scripts are fetched on first use. */
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

  /** Runs an export. */
  run(action: Action): void {
    this.actions.use((actions) => void actions[action]());
  }

  /** Copies the picture to the clipboard. Must be called while a click is handled. */
  copy(): void {
    // Reports in the status line if the script cannot be fetched.
    this.actions.use(() => {});
    void copyPicture(() => this.actions.fetch().then((actions) => actions.drawPicture()), this.status);
  }

  openCode(): void {
    this.codeDialog.use((dialog) => dialog.open());
  }
}
