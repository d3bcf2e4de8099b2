/**
 * Counts how often a pointer was pressed on the page.
 *
 * @returns tells the number of the press that lasts, or undefined if nothing is pressed
 */
export function watchPresses(): () => number | undefined {
  let count = 0;
  let isPressed = false;
  // Of several fingers, the first. Seen before whoever changes something by them.
  const listen = (type: 'pointerdown' | 'pointerup' | 'pointercancel', next: boolean): void =>
    addEventListener(
      type,
      ({ isPrimary }) => {
        if (!isPrimary) return;
        if (next) count++;
        isPressed = next;
      },
      { capture: true },
    );
  listen('pointerdown', true);
  listen('pointerup', false);
  listen('pointercancel', false);
  return () => (isPressed ? count : undefined);
}
