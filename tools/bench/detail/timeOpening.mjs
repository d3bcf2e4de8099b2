import { timeDrop } from '../drop/timeDrop.mjs';

/**
 * Opens a file on the playground. Beside what `timeDrop` gives, it tells when each stage that the status line names has begun, in
 * milliseconds, and how long all tasks of the main thread of 50 ms and more took.
 */
export async function timeOpening(page, path) {
  await page.evaluate(() => {
    const stages = {};
    const tasks = [];
    window.opening = { stages, tasks };
    document.querySelector('#file-input').addEventListener(
      'change',
      () => {
        const start = performance.now();
        new PerformanceObserver((list) => {
          for (const { startTime, duration } of list.getEntries()) tasks.push([startTime - start, duration]);
        }).observe({ entryTypes: ['longtask'] });
        const status = document.querySelector('#status');
        new MutationObserver(() => {
          const stage = /^[A-Z][a-z]+/.exec(status.textContent)?.[0];
          if (stage) stages[stage] ??= performance.now() - start;
        }).observe(status, { childList: true, characterData: true, subtree: true });
      },
      { capture: true, once: true },
    );
  });
  const times = await timeDrop(page, path);
  return { ...times, ...(await page.evaluate(() => window.opening)) };
}
