import { GALLERY, type GalleryDrawing } from '../../viewer/settings/gallery.js';

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
    const button = Object.assign(document.createElement('button'), { type: 'button' });
    const picture = Object.assign(document.createElement('img'), {
      loading: 'lazy',
      decoding: 'async',
      alt: '',
      width: SIDE,
      height: SIDE,
      src: `gallery/${drawing.name}.webp`,
    });
    button.append(picture, Object.assign(document.createElement('span'), { textContent: drawing.title }));
    if (drawing.credit) {
      const credit = Object.assign(document.createElement('small'), { textContent: drawing.credit });
      button.append(' ', credit);
    }
    button.addEventListener('click', () => {
      this.close();
      this.onChoose(drawing);
    });
    return button;
  }
}
