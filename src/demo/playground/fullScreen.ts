/** Lets an element fill the screen, or takes it back. Rejects where the browser does not allow it. */
export async function toggleFullScreen(element: HTMLElement): Promise<void> {
  if (document.fullscreenElement) await document.exitFullscreen();
  else await element.requestFullscreen();
}

/** Whether keys ask for it: F, but where it is a letter or chooses among names. */
export function isFullScreenKey({ key, target, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  const takesLetters = target instanceof Element && target.closest('input:not([type="range"]), select, textarea');
  return key.toLowerCase() === 'f' && !ctrlKey && !metaKey && !altKey && !takesLetters;
}
