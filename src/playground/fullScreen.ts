/** Lets an element fill the screen, or takes it back. Rejects where the browser does not allow it. */
export async function toggleFullScreen(element: HTMLElement): Promise<void> {
  if (document.fullscreenElement) await document.exitFullscreen();
  else await element.requestFullscreen();
}
