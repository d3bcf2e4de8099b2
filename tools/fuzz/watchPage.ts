import type { Page } from '@playwright/test';

declare global {
  interface Window {
    /** Events of the page since the last call, recorded by {@link watchPage}. */
    __watch?: { longest: number; complaints: string[]; takeTasks(): void };
  }
}

/** Events of the page since the last call. */
export interface PageWatch {
  /** Milliseconds of the longest task on the main thread; 0 if none was longer than 50. */
  longest: number;
  /** Values that are not finite and were given to WebGL, and the errors of WebGL. */
  complaints: string[];
}

/**
 * Watches the long tasks of a page, its calls of WebGL, and its requests to other hosts, from its first script on. Call it before the
 * page is opened.
 *
 * @returns the addresses on other hosts that the page requests
 */
export async function watchPage(page: Page, address: string): Promise<string[]> {
  const elsewhere: string[] = [];
  page.on('request', (request) => {
    const url = new URL(request.url());
    if (!['data:', 'blob:'].includes(url.protocol) && url.origin !== new URL(address).origin) elsewhere.push(url.href);
  });
  await page.addInitScript(watch);
  return elsewhere;
}

/** Returns what the page did since the last call, and starts anew. */
export function takeWatch(page: Page): Promise<PageWatch> {
  return page.evaluate(() => {
    const watched = window.__watch!;
    watched.takeTasks();
    const { longest, complaints } = watched;
    watched.longest = 0;
    const gl = document.querySelector<HTMLCanvasElement>('#drawing')!.getContext('webgl2')!;
    const error = gl.getError();
    const errors = error === gl.NO_ERROR ? [] : [`gl.getError: 0x${error.toString(16)}`];
    return { longest, complaints: [...complaints.splice(0), ...errors] };
  });
}

/** Runs in the page before its own scripts. */
function watch(): void {
  const observer = new PerformanceObserver((list) => note(list.getEntries()));
  const watched = {
    longest: 0,
    complaints: [] as string[],
    takeTasks: () => note(observer.takeRecords()),
  };
  window.__watch = watched;
  function note(tasks: PerformanceEntryList): void {
    for (const { duration } of tasks) watched.longest = Math.max(watched.longest, duration);
  }
  observer.observe({ type: 'longtask' });

  const isUsable = (value: unknown): boolean =>
    value instanceof Float32Array ? value.every(Number.isFinite) : typeof value !== 'number' || Number.isFinite(value);
  const prototype = WebGL2RenderingContext.prototype as unknown as Record<string, (...args: unknown[]) => unknown>;
  for (const name of Object.getOwnPropertyNames(prototype)) {
    if (!/^(buffer(Sub)?Data|uniform.*[1-4]f|uniformMatrix|tex(Sub)?Image|vertexAttrib\df|clearColor)/.test(name))
      continue;
    const call = prototype[name];
    prototype[name] = function (...args) {
      // One complaint of each kind is enough.
      if (!args.every(isUsable) && watched.complaints.length < 5)
        watched.complaints.push(`${name} is given NaN or infinity`);
      return call.apply(this, args);
    };
  }
}
