import { shownName } from '../../viewer/files/common/shownText.js';
import { findElement, textButton } from '../page/elements.js';
import type { DrawingStore } from '../session/DrawingStore.js';
import type { KeptDrawing } from '../storage/KeptDrawings.js';

/** The list of stored drawings, each of which can be opened or deleted. */
export class RecentDialog {
  private readonly dialog = findElement('recent') as HTMLDialogElement;
  private readonly rows = findElement('recent-list');
  private readonly forgetAll = findElement('recent-forget');

  constructor(
    private readonly keeper: DrawingStore,
    private readonly onOpen: (id: string) => void,
  ) {
    findElement('recent-close').addEventListener('click', () => this.dialog.close());
    this.forgetAll.addEventListener('click', async () => {
      await keeper.forget((await keeper.list()).map(({ id }) => id));
      await this.show();
    });
  }

  async open(): Promise<void> {
    await this.show();
    this.dialog.showModal();
  }

  private async show(): Promise<void> {
    const drawings = await this.keeper.list();
    this.rows.replaceChildren(...drawings.map((drawing) => this.row(drawing)));
    findElement('recent-none').hidden = drawings.length > 0;
    this.forgetAll.hidden = drawings.length === 0;
  }

  private row({ id, title, at, bytes, picture }: KeptDrawing): HTMLElement {
    const name = shownName(title);
    const open = textButton(name, () => {
      this.dialog.close();
      this.onOpen(id);
    });
    const image = document.createElement('img');
    image.alt = '';
    // An image without a source keeps its place, so that the names are aligned.
    if (picture) image.src = picture;
    open.prepend(image);
    const forgetThis = async (): Promise<void> => {
      await this.keeper.forget([id]);
      await this.show();
      (this.rows.querySelector('button') ?? findElement('recent-close')).focus();
    };
    const forget = textButton('Forget', () => void forgetThis(), `Forget ${name}`);
    const facts = Object.assign(document.createElement('span'), { textContent: `${dayOf(at)}, ${inMegabytes(bytes)}` });
    const row = document.createElement('li');
    row.append(open, facts, forget);
    return row;
  }
}

const dayOf = (at: number): string =>
  new Date(at).toLocaleString('en', {
    day: 'numeric',
    month: 'long',
    hour: '2-digit',
    minute: '2-digit',
    hourCycle: 'h23',
  });

const inMegabytes = (bytes: number): string => `${Math.max(0.1, bytes / 2 ** 20).toFixed(1)} MB`;
