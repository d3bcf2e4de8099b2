/** A visitor without any input for this long has left. */
const PATIENCE_MILLISECONDS = 60_000;

/** Restores the first drawing after a visitor has left. */
export class Kiosk {
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param reset restores the first drawing */
  constructor(private readonly reset: () => void) {
    for (const name of ['pointerdown', 'pointermove', 'keydown', 'wheel']) {
      addEventListener(name, this.onTouch, { passive: true, capture: true });
    }
    // A long press or the right button would open the browser's menu.
    addEventListener('contextmenu', (event) => event.preventDefault());
  }

  private readonly onTouch = (): void => {
    clearTimeout(this.timer);
    this.timer = setTimeout(this.reset, PATIENCE_MILLISECONDS);
  };
}
