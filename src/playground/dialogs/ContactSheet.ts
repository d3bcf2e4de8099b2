import type { TonalArtMap } from 'three-hatching';

/** Texels per side that are shown of an image: all of coarse levels, and a corner of finer ones. */
const CELL = 64;
const GAP = 6;

export interface ContactSheetElements {
  sheet: HTMLElement;
  scroller: HTMLElement;
  caption: HTMLElement;
  close: HTMLButtonElement;
}

/**
 * Shows the hatch images of the present tonal art map, one pixel per texel: tones darken to the right, levels coarsen downwards. Each tone
 * is drawn in a task of its own, so that frames are not delayed.
 */
export class ContactSheet {
  private readonly canvas = document.createElement('canvas');
  private map: TonalArtMap | undefined;
  private name = '';
  private opener: Element | null = null;
  /** Counts the calls of {@link draw}; only the latest call continues. */
  private drawing = 0;

  constructor(private readonly elements: ContactSheetElements) {
    const { sheet, scroller, close } = elements;
    this.canvas.setAttribute('role', 'img');
    // Focusable, so that it can be scrolled with the keyboard.
    scroller.tabIndex = 0;
    scroller.append(this.canvas);
    close.addEventListener('click', () => this.close());
    sheet.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.close();
    });
  }

  open(): void {
    const { sheet, close } = this.elements;
    this.opener = document.activeElement;
    sheet.hidden = false;
    close.focus();
    void this.draw();
  }

  close(): void {
    this.elements.sheet.hidden = true;
    this.drawing++;
    if (this.opener instanceof HTMLElement) this.opener.focus();
  }

  /** Sets the map. @param name the label of its style */
  show(map: TonalArtMap, name: string): void {
    if (map === this.map) return;
    this.map = map;
    this.name = name;
    if (!this.elements.sheet.hidden) void this.draw();
  }

  private async draw(): Promise<void> {
    const { map, canvas, name } = this;
    if (!map) return;
    const drawing = ++this.drawing;
    const sides = Array.from({ length: map.levels }, (_, level) => Math.min(CELL, map.size >> level));
    canvas.width = map.tones * (CELL + GAP) - GAP;
    canvas.height = sides.reduce((sum, side) => sum + side + GAP, -GAP);
    const context = canvas.getContext('2d')!;
    const count = `${map.tones} tones, ${map.levels} ${map.levels === 1 ? 'level' : 'levels'}`;
    this.elements.caption.textContent = `${name}: ${count}, ${map.size} texels`;
    canvas.setAttribute('aria-label', `${name}, ${count}: tones from light to dark, levels from fine to coarse`);
    for (let tone = 0; tone < map.tones; tone++) {
      await new Promise((resolve) => setTimeout(resolve));
      if (drawing !== this.drawing) return;
      let top = 0;
      for (const [level, side] of sides.entries()) {
        context.putImageData(corner(map.image(tone, level), map.size >> level, side), tone * (CELL + GAP), top);
        top += side + GAP;
      }
    }
    canvas.dataset.complete = String(drawing);
  }
}

/** Copies the first rows and columns of a hatch image. */
function corner(image: Uint8Array, size: number, side: number): ImageData {
  const pixels = new ImageData(side, side);
  for (let i = 0; i < side * side; i++) {
    const byte = image[Math.floor(i / side) * size + (i % side)];
    pixels.data.fill(byte, 4 * i, 4 * i + 3);
    pixels.data[4 * i + 3] = 255;
  }
  return pixels;
}
