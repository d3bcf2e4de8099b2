import type { Page } from '@playwright/test';

/** Takes the graphics context from the drawing. */
export async function loseContext(page: Page): Promise<void> {
  await page.evaluate(() => {
    const gl = (document.getElementById('drawing') as HTMLCanvasElement).getContext('webgl2')!;
    const extension = gl.getExtension('WEBGL_lose_context')!;
    (window as unknown as { __bringBack: () => void }).__bringBack = () => extension.restoreContext();
    extension.loseContext();
  });
}

/** Gives it back. */
export const restoreContext = (page: Page): Promise<void> =>
  page.evaluate(() => (window as unknown as { __bringBack: () => void }).__bringBack());
