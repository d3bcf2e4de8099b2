import { chromium } from '@playwright/test';
import { launchOptions } from './launchOptions.mjs';

/**
 * Starts the browser once and asks WebGL 2 for the name of the renderer.
 *
 * @returns {Promise<{ browser: string, renderer: string }>}
 * @throws if the browser has no WebGL 2, so that no test can pass without drawing.
 */
export async function describeRenderer() {
  const browser = await chromium.launch(await launchOptions());
  try {
    const page = await browser.newPage();
    const renderer = await page.evaluate(() => {
      const gl = document.createElement('canvas').getContext('webgl2');
      if (!gl) return null;
      const info = gl.getExtension('WEBGL_debug_renderer_info');
      return String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    });
    if (renderer === null) {
      throw new Error(
        'describeRenderer: this browser gives no WebGL2 context; set HATCH_CHROMIUM to another Chromium.',
      );
    }
    return { browser: browser.version(), renderer };
  } finally {
    await browser.close();
  }
}
