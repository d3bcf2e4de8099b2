/**
 * Whether a key was pressed as a shortcut of the page: without a modifier, and outside of fields and lists that take letters. Under an
 * open dialog the page has no shortcuts.
 */
export function isShortcut({ key, target, ctrlKey, metaKey, altKey }: KeyboardEvent, ...keys: string[]): boolean {
  if (ctrlKey || metaKey || altKey || !keys.includes(key.toLowerCase())) return false;
  const takesLetters = target instanceof Element && target.closest('input:not([type="range"]), select, textarea');
  return !takesLetters && !isDialogOpen();
}

export const isDialogOpen = (): boolean => document.querySelector('dialog[open]') !== null;
