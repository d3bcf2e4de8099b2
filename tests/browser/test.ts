import { test as base, expect, type Page } from '@playwright/test';
import { toleratedMessages } from './toleratedMessages.js';

export { expect };

declare global {
  interface Window {
    /** Every WebGL2 context the page has made, recorded by the fixture below. */
    __webglContexts?: WebGL2RenderingContext[];
  }
}

interface PageChecks {
  /**
   * What went wrong on the page so far: console warnings and errors, uncaught errors, crashes. A test that expects one
   * takes it out; whatever is left at the end fails the test.
   */
  pageProblems: string[];
  /** Whether `gl.getError()` is asked of every context when the test ends. On unless the test switches it off. */
  checkGlErrors: boolean;
}

/** Playwright's `test`, whose page fails the test on any console warning or error, uncaught error or GL error. */
export const test = base.extend<PageChecks>({
  checkGlErrors: [true, { option: true }],

  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the fixture's needs from this pattern.
  pageProblems: async ({}, use) => {
    await use([]);
  },

  page: async ({ page, pageProblems, checkGlErrors }, use) => {
    recordProblems(page, pageProblems);
    await page.addInitScript(recordContexts);
    await use(page);
    if (!page.isClosed()) {
      // Asked even when it is not wanted: messages still under way arrive before the answer.
      const glErrors = await readGlErrors(page);
      if (checkGlErrors) pageProblems.push(...glErrors);
    }
    expect(pageProblems, 'problems on the page').toEqual([]);
  },
});

function recordProblems(page: Page, problems: string[]): void {
  page.on('console', (message) => {
    if (message.type() !== 'warning' && message.type() !== 'error') return;
    if (toleratedMessages.some(({ pattern }) => pattern.test(message.text()))) return;
    problems.push(`console ${message.type()}: ${message.text()} (${message.location().url})`);
  });
  page.on('pageerror', (error) => problems.push(`uncaught error: ${error.stack ?? error.message}`));
  page.on('crash', () => problems.push('the page crashed'));
}

/** Runs in the page before its own scripts: notes each WebGL2 context, on page canvases and offscreen ones. */
function recordContexts(): void {
  const contexts: WebGL2RenderingContext[] = [];
  window.__webglContexts = contexts;
  for (const prototype of [HTMLCanvasElement.prototype, OffscreenCanvas.prototype] as HTMLCanvasElement[]) {
    const getContext = prototype.getContext;
    prototype.getContext = function (this: HTMLCanvasElement, ...args: [string, unknown?]) {
      const context = getContext.apply(this, args as Parameters<typeof getContext>);
      if (context instanceof WebGL2RenderingContext && !contexts.includes(context)) contexts.push(context);
      return context;
    } as typeof prototype.getContext;
  }
}

/**
 * Every GL error that is still unread in the page's contexts, as text. Contexts that are lost are passed over: whether a
 * loss was meant is for the test to say.
 */
export async function readGlErrors(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    (window.__webglContexts ?? []).flatMap((gl, index) => {
      const errors: string[] = [];
      while (!gl.isContextLost()) {
        const error = gl.getError();
        if (error === gl.NO_ERROR) break;
        errors.push(`gl.getError of context ${index}: 0x${error.toString(16)}`);
      }
      return errors;
    }),
  );
}
