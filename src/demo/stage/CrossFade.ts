/** How long the earlier picture takes to fade, in milliseconds. */
const DURATION = 350;

/** Lets one picture fade into the next: a copy of the earlier one lies over the drawing and goes. */
export class CrossFade {
  private readonly copy = document.createElement('canvas');
  private readonly context = this.copy.getContext('2d');

  constructor(private readonly drawing: HTMLCanvasElement) {
    this.copy.className = 'earlier-picture';
    this.copy.hidden = true;
    this.copy.setAttribute('aria-hidden', 'true');
    drawing.after(this.copy);
  }

  /** To be called right after the earlier picture was drawn, in the same task: the canvas does not keep it for longer. */
  start(): void {
    const { copy, context, drawing } = this;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    Object.assign(copy, { width: drawing.width, height: drawing.height });
    context?.drawImage(drawing, 0, 0);
    copy.hidden = false;
    const fading = copy.animate([{ opacity: 1 }, { opacity: 0 }], { duration: DURATION, easing: 'ease-in-out' });
    const end = (): void => {
      copy.hidden = true;
      // Its memory is needed for nothing any more.
      Object.assign(copy, { width: 0, height: 0 });
    };
    fading.finished.then(end, () => {});
  }

  dispose(): void {
    for (const animation of this.copy.getAnimations()) animation.cancel();
    this.copy.remove();
  }
}
