import { basename } from 'node:path';

/**
 * Drops a file on the playground and measures, in milliseconds: the time until the worker has read it, the time until the first frame that
 * shows the model, the time until the frame that shows it baked and with its lines, and the longest task of the main thread meanwhile,
 * which is 0 if no task took 50 ms.
 */
export async function timeDrop(page, path) {
  const name = basename(path).replace(/\.\w+$/, '');
  // Frames of the earlier model are not waited for.
  await page.evaluate(drawnFrames);
  const drawn = page.evaluate(
    (name) =>
      new Promise((resolve) => {
        const root = document.documentElement;
        const { drawing } = window;
        const picked = () => {
          const start = performance.now();
          let longestTask = 0;
          let read = 0;
          const { Worker: PlainWorker } = window;
          window.Worker = class extends PlainWorker {
            constructor(...args) {
              super(...args);
              this.addEventListener('message', ({ data }) => {
                if (data?.kind === 'done') read ||= performance.now() - start;
              });
            }
          };
          const tasks = new PerformanceObserver((list) => {
            for (const { duration } of list.getEntries()) longestTask = Math.max(longestTask, duration);
          });
          tasks.observe({ entryTypes: ['longtask'] });
          const shown = new Promise((resolve) => {
            let framesBefore;
            const look = () => {
              const { framesDrawn } = window.__playground;
              if (document.title.startsWith(name)) framesBefore ??= framesDrawn;
              if (framesBefore === undefined || framesDrawn === framesBefore) {
                requestAnimationFrame(look);
                return;
              }
              void drawing().then(() => resolve(performance.now() - start));
            };
            look();
          });
          new MutationObserver(async (_, observer) => {
            if (root.dataset.state !== 'ready') return;
            observer.disconnect();
            await drawing();
            const ready = performance.now() - start;
            const first = Math.min(await shown, ready);
            // The browser reports a task a little after it has ended.
            await new Promise((resolve) => setTimeout(resolve, 200));
            tasks.disconnect();
            window.Worker = PlainWorker;
            resolve({ read, first, ready, longestTask });
          }).observe(root, { attributeFilter: ['data-state'] });
        };
        document.querySelector('#file-input').addEventListener('change', picked, { capture: true, once: true });
      }),
    name,
  );
  await page.setInputFiles('#file-input', path);
  const times = await drawn;
  const title = await page.title();
  if (!title.includes(name)) throw new Error(`timeDrop: ${name} was not drawn, the page shows ${title}.`);
  return times;
}

/**
 * Runs in the page. Resolves when the graphics process has drawn all that it was asked for, and leaves itself there as `drawing`. It asks again
 * and again: reading a pixel would hold the main thread until then, which would count as a task of the page.
 */
async function drawnFrames() {
  const gl = document.querySelector('#drawing').getContext('webgl2');
  window.drawing = async () => {
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    gl.deleteSync(fence);
  };
  await window.drawing();
}

/** Waits until the playground has nothing left to do. */
export const untilIdle = (page) =>
  page.waitForFunction(() => document.documentElement.dataset.state === 'ready' && window.__playground.isIdle, null, {
    timeout: 120_000,
  });
