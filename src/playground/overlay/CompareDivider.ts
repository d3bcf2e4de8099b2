const STEP = 0.02;
const LARGE_STEP = 0.1;

/** The vertical divider between two drawings of the same view, moved by dragging or with the arrow keys. */
export class CompareDivider {
  /** The position of the divider, as a share of the width from the left. */
  share = 0.5;
  private readonly left = document.createElement('span');
  private readonly right = document.createElement('span');

  constructor(
    private readonly element: HTMLElement,
    private readonly viewport: HTMLElement,
    private readonly onMove: () => void,
  ) {
    element.tabIndex = 0;
    element.setAttribute('role', 'slider');
    element.setAttribute('aria-orientation', 'horizontal');
    element.setAttribute('aria-valuemin', '0');
    element.setAttribute('aria-valuemax', '100');
    this.left.className = 'divider-left';
    this.right.className = 'divider-right';
    element.append(this.left, this.right);
    element.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      element.focus({ preventScroll: true });
      element.setPointerCapture(event.pointerId);
    });
    element.addEventListener('pointermove', (event) => {
      if (!element.hasPointerCapture(event.pointerId)) return;
      const { left, width } = viewport.getBoundingClientRect();
      this.moveTo((event.clientX - left) / width);
    });
    element.addEventListener('keydown', this.onKeyDown);
  }

  /** Shows the divider with the names of both sides, or hides it. */
  show(names: { left: string; right: string } | undefined): void {
    this.element.hidden = names === undefined;
    if (!names) return;
    this.left.textContent = names.left;
    this.right.textContent = names.right;
    this.element.setAttribute('aria-label', `Divider between ${names.left} and ${names.right}`);
    this.place();
  }

  /** Moves the divider to its share of the viewport after a resize. */
  place(): void {
    this.element.style.transform = `translateX(${(this.share * this.viewport.clientWidth).toFixed(1)}px)`;
    this.element.setAttribute('aria-valuenow', (100 * this.share).toFixed(0));
  }

  private readonly onKeyDown = (event: KeyboardEvent): void => {
    const moves: Record<string, number> = {
      ArrowLeft: this.share - STEP,
      ArrowDown: this.share - STEP,
      ArrowRight: this.share + STEP,
      ArrowUp: this.share + STEP,
      PageDown: this.share - LARGE_STEP,
      PageUp: this.share + LARGE_STEP,
      Home: 0,
      End: 1,
    };
    const next = moves[event.key];
    if (next === undefined) return;
    event.preventDefault();
    this.moveTo(next);
  };

  private moveTo(share: number): void {
    this.share = Math.min(1, Math.max(0, share));
    this.place();
    this.onMove();
  }
}
