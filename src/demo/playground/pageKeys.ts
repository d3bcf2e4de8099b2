import { isDialogOpen, isShortcut } from './isShortcut.js';

/** What keys do, wherever the focus is. */
export interface PageKeys {
  close(): void;
  fillScreen(): void;
  /** Lists the keys, if the page has a list. */
  openKeys: (() => void) | undefined;
  /** @param index of a view that was kept */
  showView(index: number): void;
  undo(): void;
  redo(): void;
}

const DIGITS = ['1', '2', '3', '4', '5', '6', '7', '8', '9'];

export function listenToKeys(keys: PageKeys): void {
  addEventListener('keydown', (event) => {
    // Of what is open, one thing at a time.
    if (event.key === 'Escape' && !isDialogOpen()) keys.close();
    if (isShortcut(event, 'f')) keys.fillScreen();
    if (isShortcut(event, ...DIGITS)) keys.showView(Number(event.key) - 1);
    if (keys.openKeys && isShortcut(event, '?', 'h', 'f1')) {
      // F1 is the browser's own help.
      event.preventDefault();
      keys.openKeys();
    }
    const step = stepOf(event);
    if (!step) return;
    event.preventDefault();
    keys[step]();
  });
}

/** Whether keys ask for Undo or Redo. Fields of text have their own, and an open dialog shows what they would change. */
function stepOf({ key, target, ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent): 'undo' | 'redo' | undefined {
  const isTyping = target instanceof HTMLInputElement && target.type !== 'range';
  if (!(ctrlKey || metaKey) || altKey || isTyping || isDialogOpen()) return undefined;
  if (key.toLowerCase() === 'z') return shiftKey ? 'redo' : 'undo';
  return key.toLowerCase() === 'y' && ctrlKey && !shiftKey ? 'redo' : undefined;
}
