import { shownName } from '../../viewer/files/common/ModelError.js';
import { GALLERY, type GalleryDrawing } from '../../viewer/settings/gallery.js';
import { element, findElement, textButton } from '../page/elements.js';
import type { DrawingStore } from '../session/DrawingStore.js';
import type { KeptDrawing } from '../session/KeptDrawings.js';

/** The size of the pictures in pixels. */
const SIDE = 256;

/** Shows finished drawings as thumbnails over the sheet. A click opens a drawing. */
export class Gallery {
  private opener: Element | null = null;

  constructor(
    private readonly elements: { sheet: HTMLElement; drawings: HTMLElement; close: HTMLElement },
    private readonly onChoose: (drawing: GalleryDrawing) => void,
  ) {
    elements.close.addEventListener('click', () => this.close());
    elements.sheet.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.close();
    });
  }

  open(): void {
    const { sheet, drawings, close } = this.elements;
    // Pictures are created on opening, so that a page with a closed gallery fetches none.
    if (drawings.childElementCount === 0) drawings.append(...GALLERY.map((drawing) => this.button(drawing)));
    this.opener = document.activeElement;
    sheet.hidden = false;
    close.focus();
  }

  private close(): void {
    this.elements.sheet.hidden = true;
    if (this.opener instanceof HTMLElement) this.opener.focus();
  }

  private button(drawing: GalleryDrawing): HTMLElement {
    const src = `gallery/${drawing.name}.webp`;
    const picture = element('img', { loading: 'lazy', decoding: 'async', alt: '', width: SIDE, height: SIDE, src });
    const button = element('button', { type: 'button' }, picture, element('span', {}, drawing.title));
    if (drawing.credit) button.append(' ', element('small', {}, drawing.credit));
    button.addEventListener('click', () => {
      this.close();
      this.onChoose(drawing);
    });
    return button;
  }
}

/** Keys and gestures, grouped by where they work. All keys of a row do what `text` says. */
const KEYS: readonly { about: string; rows: readonly (readonly [keys: string, text: string])[] }[] = [
  {
    about: 'Mouse and fingers',
    rows: [
      ['Drag', 'turns the model; the lamp moves the light, past the edge of the model and back behind it'],
      ['Wheel, pinch', 'nearer, farther'],
      ['Right button, two fingers', 'move the model'],
      ['Double-click', 'shows the model whole; on the name of a setting, resets it'],
      ['Shift, second finger', 'while a lamp or spot is dragged, changes its distance'],
    ],
  },
  {
    about: 'The drawing, once it is clicked or reached with Tab',
    rows: [
      ['← → ↑ ↓', 'turn it, with Shift finely'],
      ['+ −', 'nearer, farther'],
      ['W A S D', 'move it'],
      ['Home', 'show it whole'],
      ['Space', 'play or pause a model that moves'],
    ],
  },
  {
    about: 'The light, reached with Tab',
    rows: [
      ['← → ↑ ↓', 'move it, with Shift finely'],
      ['Page Up, Page Down', 'farther, nearer, if it is a lamp or a spot'],
      ['Home', 'where it was at first'],
    ],
  },
  {
    about: 'Everywhere but in a field',
    rows: [
      ['Ctrl Z', 'undo'],
      ['Ctrl Y, Ctrl Shift Z', 'redo'],
      ['V', 'another view of the model'],
      ['1 to 9', 'go to a view that was kept'],
      ['F', 'full screen'],
      ['Esc', 'close what is open'],
      ['?, H, F1', 'these keys'],
    ],
  },
];

/** The list of keys and gestures. */
export class KeysDialog {
  private readonly dialog = findElement('keys') as HTMLDialogElement;

  constructor() {
    findElement('keys-close').addEventListener('click', () => this.dialog.close());
    findElement('keys-list').append(
      ...KEYS.flatMap(({ about, rows }) => [
        element('h3', {}, about),
        element('dl', {}, ...rows.flatMap(([keys, text]) => [element('dt', {}, keys), element('dd', {}, text)])),
      ]),
    );
  }

  open(): void {
    if (!this.dialog.open) this.dialog.showModal();
  }
}

/** The list of stored drawings, each of which can be opened or deleted. */
export class RecentDialog {
  private readonly dialog = findElement('recent') as HTMLDialogElement;
  private readonly rows = findElement('recent-list');
  private readonly forgetAll = findElement('recent-forget');

  constructor(
    private readonly store: DrawingStore,
    private readonly onOpen: (id: string) => void,
  ) {
    findElement('recent-close').addEventListener('click', () => this.dialog.close());
    this.forgetAll.addEventListener('click', async () => {
      await store.forget((await store.list()).map(({ id }) => id));
      await this.show();
    });
  }

  async open(): Promise<void> {
    await this.show();
    this.dialog.showModal();
  }

  private async show(): Promise<void> {
    const drawings = await this.store.list();
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
    // An image without a source keeps its place, so that the names are aligned.
    open.prepend(element('img', { alt: '', ...(picture && { src: picture }) }));
    const forgetThis = async (): Promise<void> => {
      await this.store.forget([id]);
      await this.show();
      (this.rows.querySelector('button') ?? findElement('recent-close')).focus();
    };
    const forget = textButton('Forget', () => void forgetThis(), `Forget ${name}`);
    return element('li', {}, open, element('span', {}, `${dayOf(at)}, ${inMegabytes(bytes)}`), forget);
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
