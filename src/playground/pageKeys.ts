/**
 * Whether a key was pressed as a shortcut of the page: without a modifier, and outside of fields and lists that take letters. Under an
 * open dialog the page has no shortcuts.
 */
export function isShortcut({ key, target, ctrlKey, metaKey, altKey }: KeyboardEvent, ...keys: string[]): boolean {
  if (ctrlKey || metaKey || altKey || !keys.includes(key.toLowerCase())) return false;
  const takesLetters = target instanceof Element && target.closest('input:not([type="range"]), select, textarea');
  return !takesLetters && !isDialogOpen();
}

const isDialogOpen = (): boolean => document.querySelector('dialog[open]') !== null;

/** What the keys of the page do, wherever the focus is. */
export interface PageKeys {
  close(): void;
  fillScreen(): void;
  /** Lists the keys, if the page has a list. */
  openKeys: (() => void) | undefined;
  /** @param index the index of a saved view */
  showView(index: number): void;
  undo(): void;
  redo(): void;
}

const DIGITS = ['1', '2', '3', '4', '5', '6', '7', '8', '9'];

export function listenToKeys(keys: PageKeys): void {
  addEventListener('keydown', (event) => {
    // Escape closes one thing at a time.
    if (event.key === 'Escape' && !isDialogOpen()) keys.close();
    if (isShortcut(event, 'f')) keys.fillScreen();
    if (isShortcut(event, ...DIGITS)) keys.showView(Number(event.key) - 1);
    if (keys.openKeys && isShortcut(event, '?', 'h', 'f1')) {
      // F1 would open the browser's help.
      event.preventDefault();
      keys.openKeys();
    }
    const step = stepOf(event);
    if (!step) return;
    event.preventDefault();
    keys[step]();
  });
}

/** Whether keys ask for Undo or Redo. Text fields have an Undo of their own, and under an open dialog the drawing must not change. */
function stepOf({ key, target, ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent): 'undo' | 'redo' | undefined {
  const isTyping = target instanceof HTMLInputElement && target.type !== 'range';
  if (!(ctrlKey || metaKey) || altKey || isTyping || isDialogOpen()) return undefined;
  if (key.toLowerCase() === 'z') return shiftKey ? 'redo' : 'undo';
  return key.toLowerCase() === 'y' && ctrlKey && !shiftKey ? 'redo' : undefined;
}
