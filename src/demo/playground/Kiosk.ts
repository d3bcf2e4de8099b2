/** A visitor who does nothing for so long has gone. */
const PATIENCE_MILLISECONDS = 60_000;

/** Brings the drawing back to how it was at first when a visitor has gone. */
export class Kiosk {
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param reset brings the first drawing back */
  constructor(private readonly reset: () => void) {
    for (const name of ['pointerdown', 'pointermove', 'keydown', 'wheel']) {
      addEventListener(name, this.onTouch, { passive: true, capture: true });
    }
    // A long press, or the right button, would bring up the browser's menu.
    addEventListener('contextmenu', (event) => event.preventDefault());
  }

  private readonly onTouch = (): void => {
    clearTimeout(this.timer);
    this.timer = setTimeout(this.reset, PATIENCE_MILLISECONDS);
  };
}
