import type { Page } from '@playwright/test';

/** CSS that makes letters as wide as those of a typewriter: no reader's font is wider. */
export const TYPEWRITER = '0.07em';

/** Widens all letters of the page, as another font would. @param spacing what is added to each, a length in CSS */
export const widenLetters = (page: Page, spacing: string): Promise<void> =>
  page.evaluate((width) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(`* { letter-spacing: ${width} }`);
    document.adoptedStyleSheets.push(sheet);
  }, spacing);
