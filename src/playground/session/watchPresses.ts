/**
 * Numbers the pointer presses on the page.
 *
 * @returns a function that returns the number of the present press, or undefined without one
 */
export function watchPresses(): () => number | undefined {
  let count = 0;
  let isPressed = false;
  // Only the first of several fingers counts. The events are captured, so that they are seen before a control reacts to them.
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
