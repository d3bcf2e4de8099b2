import type { Page } from '@playwright/test';

/** Number of objects of each kind: GL objects, workers, blobs with a URL, event listeners, elements. */
export type LiveObjects = Record<string, number>;

declare global {
  interface Window {
    /** Objects that were created and not disposed of, recorded by {@link countObjects}. */
    __live?: Record<string, Set<unknown>>;
  }
}

/** Counts the objects that the page creates and disposes of, from its first script on. Call it before the page is opened. */
export async function countObjects(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const live: Record<string, Set<unknown>> = {};
    window.__live = live;
    const setOf = (kind: string): Set<unknown> => {
      live[kind] ??= new Set();
      return live[kind];
    };
    const gl = WebGL2RenderingContext.prototype as unknown as Record<string, (...args: unknown[]) => unknown>;
    const wrap = (name: string, then: (made: unknown, args: unknown[]) => void): void => {
      const call = gl[name];
      gl[name] = function (...args: unknown[]) {
        const made = call.apply(this, args);
        then(made, args);
        return made;
      };
    };
    const kinds = 'Buffer Texture Program Shader Framebuffer Renderbuffer VertexArray Query Sampler TransformFeedback';
    for (const kind of kinds.split(' ')) {
      wrap(`create${kind}`, (made) => setOf(kind).add(made));
      wrap(`delete${kind}`, (_, [gone]) => setOf(kind).delete(gone));
    }
    wrap('fenceSync', (made) => setOf('Sync').add(made));
    wrap('deleteSync', (_, [gone]) => setOf('Sync').delete(gone));

    const workers = setOf('Worker');
    const urls = setOf('URL');
    window.Worker = class extends Worker {
      constructor(...args: ConstructorParameters<typeof Worker>) {
        super(...args);
        workers.add(this);
        // A worker of ours frees the URL of its own text before it answers.
        this.addEventListener('message', () => urls.delete(String(args[0])), { once: true });
      }

      override terminate(): void {
        workers.delete(this);
        super.terminate();
      }
    };
    const { createObjectURL, revokeObjectURL } = URL;
    URL.createObjectURL = (thing) => {
      const url = createObjectURL(thing);
      urls.add(url);
      return url;
    };
    URL.revokeObjectURL = (url) => {
      urls.delete(url);
      revokeObjectURL(url);
    };
  });
}

/** The counts after a garbage collection; `kilobytes` are those of all typed arrays: geometries, pictures, maps. */
export async function liveObjects(page: Page): Promise<LiveObjects> {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable');
  // Objects that a finaliser releases in the first collection are collected in the second.
  for (let i = 0; i < 2; i++) {
    await session.send('HeapProfiler.collectGarbage');
    await page.evaluate(() => new Promise((resolve) => setTimeout(resolve)));
  }
  const { metrics } = await session.send('Performance.getMetrics');
  const metric = (wanted: string): number => metrics.find(({ name }) => name === wanted)?.value ?? Number.NaN;
  const { backingStorageSize } = (await session.send('Runtime.getHeapUsage')) as { backingStorageSize?: number };
  await session.detach();
  const made = await page.evaluate(() =>
    Object.fromEntries(Object.entries(window.__live!).map(([kind, objects]) => [kind, objects.size])),
  );
  return {
    ...made,
    listeners: metric('JSEventListeners'),
    nodes: metric('Nodes'),
    kilobytes: Math.round((backingStorageSize ?? Number.NaN) / 1000),
  };
}
