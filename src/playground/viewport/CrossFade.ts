/** Duration of the fade, in milliseconds. */
const DURATION = 350;

/** Fades one picture into the next: a copy of the earlier picture lies over the drawing and becomes transparent. */
export class CrossFade {
  private readonly copy = document.createElement('canvas');
  private readonly context = this.copy.getContext('2d');
  private isKept = false;

  /**
   * @param under the canvas below the copy
   * @param drawn returns the canvas that shows the drawing
   */
  constructor(
    under: HTMLCanvasElement,
    private readonly drawn: () => HTMLCanvasElement,
  ) {
    this.copy.className = 'earlier-picture';
    this.copy.hidden = true;
    this.copy.setAttribute('aria-hidden', 'true');
    under.after(this.copy);
  }

  /** Whether an earlier picture is stored or fading. */
  get isBusy(): boolean {
    return this.isKept || this.isFading;
  }

  /** Whether an earlier picture is fading. */
  get isFading(): boolean {
    return !this.copy.hidden;
  }

  /** Makes the browser set up copying in advance, since during a frame that would wait for the picture. */
  prepare(): void {
    const { copy, context } = this;
    Object.assign(copy, { width: 1, height: 1 });
    context?.drawImage(this.drawn(), 0, 0);
  }

  /**
   * Copies the picture, unless an earlier one is fading, which would jump. Call this in the task in which the picture was drawn, because
   * the canvas does not keep its content.
   */
  keep(): void {
    const { copy, context } = this;
    if (this.isFading) return;
    const drawing = this.drawn();
    if (copy.width !== drawing.width || copy.height !== drawing.height) {
      Object.assign(copy, { width: drawing.width, height: drawing.height });
    }
    context?.drawImage(drawing, 0, 0);
    this.isKept = true;
  }

  /** Discards the copied picture, unless it is fading already. */
  forgetKept(): void {
    if (this.isKept && !this.isFading) this.forget();
  }

  /** Fades the copied picture, if there is one, into the drawing. */
  start(): void {
    const { copy } = this;
    if (!this.isKept) return;
    this.isKept = false;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.forget();
      return;
    }
    copy.hidden = false;
    const fading = copy.animate([{ opacity: 1 }, { opacity: 0 }], { duration: DURATION, easing: 'ease-in-out' });
    fading.finished.then(
      () => this.forget(),
      () => {},
    );
  }

  /** Frees the memory of the copied picture. */
  forget(): void {
    this.isKept = false;
    this.copy.hidden = true;
    Object.assign(this.copy, { width: 0, height: 0 });
  }
}
