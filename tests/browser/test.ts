import { test as base, expect as baseExpect, type ConsoleMessage, type Page } from '@playwright/test';
import { toleratedMessages } from '../../tools/browser/toleratedMessages.js';
import { isTimeUp, TIME_IS_UP } from '../timeLimit.mjs';
import { passNumbersAsBytes } from './passNumbersAsBytes.js';
import { recordLimits } from './recordLimits.js';
import { serveTests } from './serveTests.js';
import type { ThreeOptions } from './ThreeOptions.js';

export const expect = recordLimits(baseExpect, process.env.HATCH_LIMITS);

declare global {
  interface Window {
    /** Every WebGL2 context the page has made, recorded by the fixture below. */
    __webglContexts?: WebGL2RenderingContext[];
  }
}

interface Site {
  /** Base URL of the pages. */
  site: string | undefined;
}

interface PageChecks {
  /** Leaves the test out where the time of the run is up. */
  inTime: undefined;
  /**
   * Problems of the page so far: console warnings and errors, uncaught errors, crashes. A test that expects one
   * takes it out; whatever is left at the end fails the test.
   */
  pageProblems: string[];
  /** Whether `gl.getError()` is asked of every context when the test ends. On unless the test switches it off. */
  checkGlErrors: boolean;
}

/** Playwright's `test`, whose page fails the test on any console warning or error, uncaught error or GL error. */
export const test = base.extend<PageChecks, ThreeOptions & Site>({
  three: [undefined, { option: true, scope: 'worker' }],

  site: [
    async ({ three }, use, { project }) => {
      if (three === undefined) {
        await use(project.use.baseURL);
        return;
      }
      const server = await serveTests(three);
      await use(server.url);
      await server.close();
    },
    { scope: 'worker' },
  ],

  baseURL: ({ site }, use) => use(site),

  inTime: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the fixture's needs from this pattern.
    async ({}, use, testInfo) => {
      testInfo.skip(isTimeUp(), TIME_IS_UP);
      await use(undefined);
    },
    { auto: true },
  ],

  checkGlErrors: [true, { option: true }],

  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the fixture's needs from this pattern.
  pageProblems: async ({}, use) => {
    await use([]);
  },

  page: async ({ page, pageProblems, checkGlErrors }, use) => {
    await page.addInitScript(recordContexts);
    passNumbersAsBytes(page);
    await usePage(page, pageProblems, checkGlErrors, use);
  },
});

/** Lets `goto` fail at once where the server cannot answer, for instance because the playground could not be built: no test waits for such a page. */
function failOnServerErrors(page: Page): void {
  const goto = page.goto.bind(page);
  page.goto = async (url, options) => {
    const answer = await goto(url, options);
    if (answer && answer.status() >= 500) throw new Error(`${url}: the server answered ${answer.status()}.`);
    return answer;
  };
}

/** Lends a page, on which {@link recordContexts} has run, and fails if anything goes wrong on it meanwhile. */
async function usePage(
  page: Page,
  problems: string[],
  checkGlErrors: boolean,
  use: (page: Page) => Promise<void>,
): Promise<void> {
  const onConsole = (message: ConsoleMessage): void => {
    if (message.type() !== 'warning' && message.type() !== 'error') return;
    if (toleratedMessages.some(({ pattern }) => pattern.test(message.text()))) return;
    problems.push(`console ${message.type()}: ${message.text()} (${message.location().url})`);
  };
  const onError = (error: Error): void => void problems.push(`uncaught error: ${error.stack ?? error.message}`);
  const onCrash = (): void => void problems.push('the page crashed');
  page.on('console', onConsole).on('pageerror', onError).on('crash', onCrash);
  failOnServerErrors(page);
  await use(page);
  if (!page.isClosed()) {
    // Asked even when it is not wanted: messages still under way arrive before the answer.
    const glErrors = await readGlErrors(page);
    if (checkGlErrors) problems.push(...glErrors);
  }
  page.off('console', onConsole).off('pageerror', onError).off('crash', onCrash);
  expect(problems, 'problems on the page').toEqual([]);
}

/**
 * The same `test` with one `page` for all tests of a file, opened once at the address: for pages whose every answer depends on the
 * question alone. Loading the page takes longer than most of the pictures.
 *
 * @param options.freesContexts whether the graphics contexts that a test makes are taken away when it ends, for pages whose tests
 *   make their own: browsers keep sixteen
 * @param options.begin brings the page into the state that each test begins with. A hook would do so for one file alone, since a
 *   worker loads the module that it stands in once
 */
export const testOnOnePage = (
  address: string,
  { freesContexts = false, begin }: { freesContexts?: boolean; begin?: (page: Page) => Promise<unknown> } = {},
) =>
  test.extend<object, { onePage: Page }>({
    onePage: [
      async ({ browser, site }, use) => {
        const page = await browser.newPage({ baseURL: site });
        await page.addInitScript(recordContexts);
        passNumbersAsBytes(page);
        await page.goto(address);
        await use(page);
        await page.close();
      },
      { scope: 'worker' },
    ],
    page: async ({ onePage, pageProblems, checkGlErrors }, use) => {
      try {
        await begin?.(onePage);
        await usePage(onePage, pageProblems, checkGlErrors, use);
      } finally {
        if (freesContexts) await onePage.evaluate(freeContexts);
      }
    },
  });

export type TestOnOnePage = ReturnType<typeof testOnOnePage>;

/** Runs in the page: takes away every context that was made, and what is on the page. */
function freeContexts(): void {
  for (const gl of window.__webglContexts?.splice(0) ?? []) {
    if (!gl.isContextLost()) gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
  document.body.replaceChildren();
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
