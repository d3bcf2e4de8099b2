/** Milliseconds between two copies, while frames are drawn. */
const INTERVAL_MILLISECONDS = 1000;

/**
 * Keeps a copy of the latest picture, which is shown while the graphics context is lost. The copy lies behind the drawing and in main
 * memory, because GPU memory is lost with the context. Copying takes time, so it starts only after a first loss.
 */
export class LastPicture {
  private copy = document.createElement('canvas');
  /** The pixels are kept too: when the GPU process ends, browsers blank canvases of every kind. */
  private pixels: ImageData | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private keptAt = -Infinity;

  /** @param draw draws the picture again, and returns whether there is one */
  constructor(
    private readonly drawing: HTMLCanvasElement,
    private readonly draw: () => boolean,
  ) {
    this.copy.className = 'last-picture';
    this.copy.hidden = true;
    this.copy.setAttribute('aria-hidden', 'true');
    drawing.before(this.copy);
  }

  private get context(): CanvasRenderingContext2D | null {
    return this.copy.getContext('2d', { willReadFrequently: true });
  }

  /** Whether there is a picture to show. */
  get isKept(): boolean {
    return this.pixels !== undefined;
  }

  /** Call this after each frame. The last frame of a movement is copied too, a little later. */
  frameDrawn(): void {
    if (this.timer !== undefined) return;
    const wait = Math.max(0, this.keptAt + INTERVAL_MILLISECONDS - performance.now());
    this.timer = setTimeout(() => {
      this.timer = undefined;
      this.keep();
    }, wait);
  }

  /** Shows the copy, if there is one. */
  lost(): void {
    this.stop();
    if (this.pixels) {
      // A canvas that was blanked stays blank, so a new one replaces it.
      const canvas = this.copy.cloneNode() as HTMLCanvasElement;
      this.copy.replaceWith(canvas);
      this.copy = canvas;
      this.context?.putImageData(this.pixels, 0, 0);
    }
    this.copy.hidden = !this.isKept;
    this.drawing.classList.toggle('is-lost', this.isKept);
  }

  /** Shows the drawing again. */
  restored(): void {
    this.copy.hidden = true;
    this.drawing.classList.remove('is-lost');
  }

  private stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private keep(): void {
    const { copy, context, drawing } = this;
    // Drawn and copied in one task, because the canvas does not keep its content.
    if (!this.draw()) return;
    this.keptAt = performance.now();
    if (copy.width !== drawing.width || copy.height !== drawing.height) {
      Object.assign(copy, { width: drawing.width, height: drawing.height });
    }
    context?.clearRect(0, 0, copy.width, copy.height);
    context?.drawImage(drawing, 0, 0);
    this.pixels = context?.getImageData(0, 0, copy.width, copy.height);
  }
}
