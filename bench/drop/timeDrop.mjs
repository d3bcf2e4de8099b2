import { basename } from 'node:path';

/** Hands a file to the playground: milliseconds until the first frame that shows it can be read. */
export async function timeDrop(page, path) {
  const drawn = page.evaluate(
    () =>
      new Promise((resolve) => {
        const root = document.documentElement;
        const gl = document.querySelector('#drawing').getContext('webgl2');
        const picked = () => {
          const start = performance.now();
          new MutationObserver((_, observer) => {
            if (root.dataset.state !== 'ready') return;
            observer.disconnect();
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
            resolve(performance.now() - start);
          }).observe(root, { attributeFilter: ['data-state'] });
        };
        document.querySelector('#file-input').addEventListener('change', picked, { capture: true, once: true });
      }),
  );
  await page.setInputFiles('#file-input', path);
  const time = await drawn;
  const [title, name] = [await page.title(), basename(path).replace(/\.\w+$/, '')];
  if (!title.includes(name)) throw new Error(`timeDrop: ${name} was not drawn, the page shows ${title}.`);
  return time;
}

/** Waits until the playground has nothing left to do. */
export const untilIdle = (page) =>
  page.waitForFunction(() => document.documentElement.dataset.state === 'ready' && window.__playground.isIdle, null, {
    timeout: 120_000,
  });
