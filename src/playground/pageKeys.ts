/** Whether a key press is a shortcut of the page: without modifiers, outside text fields and lists, and without an open dialog. */
export function isShortcut({ key, target, ctrlKey, metaKey, altKey }: KeyboardEvent, ...keys: string[]): boolean {
  if (ctrlKey || metaKey || altKey || !keys.includes(key.toLowerCase())) return false;
  const takesLetters = target instanceof Element && target.closest('input:not([type="range"]), select, textarea');
  return !takesLetters && !isDialogOpen();
}

const isDialogOpen = (): boolean => document.querySelector('dialog[open]') !== null;

/** The actions of the page's keys. */
export interface PageKeys {
  close(): void;
  fillScreen(): void;
  showAnotherView(): void;
  /** Opens the list of keys, if the page has one. */
  openKeys: (() => void) | undefined;
  /** @param index of a saved view */
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
    if (isShortcut(event, 'v')) keys.showAnotherView();
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

/** Whether keys mean Undo or Redo. Text fields have their own Undo, and the drawing must not change below an open dialog. */
function stepOf({ key, target, ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent): 'undo' | 'redo' | undefined {
  const isTyping = target instanceof HTMLInputElement && target.type !== 'range';
  if (!(ctrlKey || metaKey) || altKey || isTyping || isDialogOpen()) return undefined;
  if (key.toLowerCase() === 'z') return shiftKey ? 'redo' : 'undo';
  return key.toLowerCase() === 'y' && ctrlKey && !shiftKey ? 'redo' : undefined;
}
