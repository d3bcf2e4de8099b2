import { readFile } from 'node:fs/promises';
import { expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';

import type { TestFile } from '../modelFiles/modelFiles.js';

/** Opens the playground with the hash of a link and waits until it shows the drawing. */
export async function openPlayground(page: Page, hash = ''): Promise<void> {
  await page.goto(`./#${hash}`);
  await ready(page);
}

/** Longer than anything here should take, also on a slow machine. */
const STUCK_MILLISECONDS = 120_000;

/** Waits until the page has handled what was done to it: some of that begins in a later task, or with the next refresh of the screen. */
export const handled = (page: Page): Promise<void> =>
  page.evaluate(() => new Promise<void>((resolve) => requestAnimationFrame(() => setTimeout(resolve))));

/** Waits until the page shows a drawing and is idle: nothing is loading, baking, moving or fading. */
export async function ready(page: Page): Promise<void> {
  await handled(page);
  await page.waitForFunction(
    () => document.documentElement.dataset.state === 'ready' && window.__playground!.isIdle,
    null,
    { timeout: STUCK_MILLISECONDS },
  );
}

/** Waits until the page is idle, with or without a drawing. A clip that plays is stopped, because it would go on for ever. */
export async function idle(page: Page): Promise<void> {
  await handled(page);
  await page.waitForFunction(
    () => {
      const playing = [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Pause');
      playing?.click();
      return window.__playground!.isIdle;
    },
    null,
    { timeout: STUCK_MILLISECONDS },
  );
}

/** Waits for some refreshes of the screen, in each of which the page could draw a frame. */
export const refreshes = (page: Page, count: number): Promise<void> =>
  page.evaluate(async (awaited) => {
    for (let i = 0; i < awaited; i++) await new Promise(requestAnimationFrame);
  }, count);

/** Waits until the page has fetched ahead what nobody has opened yet, and returns the names of those files. */
export async function fetchedAhead(page: Page): Promise<string[]> {
  const parts = (await (await page.request.get(new URL('parts.json', page.url()).href)).json()) as string[];
  await expect
    .poll(() =>
      page.evaluate((names) => {
        const fetched = performance.getEntriesByType('resource').map(({ name }) => name);
        return names.filter((name) => !fetched.some((address) => address.endsWith(name)));
      }, parts),
    )
    .toEqual([]);
  return parts;
}

/** Follows a link in the open page. */
export async function follow(page: Page, hash: string): Promise<void> {
  await enterLink(page, hash);
  await idle(page);
}

/** Pastes a link into the address, and waits for the event of the change, which comes in its own task. */
export async function enterLink(page: Page, hash: string): Promise<void> {
  await page.evaluate(async (link) => {
    if (location.hash === `#${link}`) return;
    const arrived = new Promise<void>((resolve) => {
      addEventListener('hashchange', () => setTimeout(resolve), { once: true });
    });
    location.hash = link;
    await arrived;
  }, hash);
}

/** The hash of the page's address, for which the page would wait for a moment without changes. The page writes it now, as before it is left. */
export async function writtenHash(page: Page): Promise<string> {
  await ready(page);
  return page.evaluate(() => {
    dispatchEvent(new Event('pagehide'));
    return location.hash;
  });
}

/** Drags files over the page and drops them. */
export async function drop(page: Page, files: readonly TestFile[]): Promise<void> {
  const plain = files.map(({ name, buffer }) => ({ name, base64: buffer.toString('base64') }));
  const transfer = await page.evaluateHandle((dropped) => {
    const data = new DataTransfer();
    for (const { name, base64 } of dropped) {
      data.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    }
    return data;
  }, plain);
  await page.dispatchEvent('body', 'dragenter', { dataTransfer: transfer });
  await expect(page.getByText('Drop a model to have it drawn')).toBeVisible();
  await page.dispatchEvent('body', 'drop', { dataTransfer: transfer });
  await transfer.dispose();
  await expect(page.getByText('Drop a model to have it drawn')).toBeHidden();
}

export const framesDrawn = (page: Page): Promise<number> => page.evaluate(() => window.__playground!.framesDrawn);

/** A screenshot of the drawing alone, without lamp, divider, focus ring and sentences that lie over it. */
export async function readDrawing(page: Page): Promise<PNG> {
  await ready(page);
  const overlays = page.locator('.lamp, #divider, #status');
  const canvas = page.locator('#drawing');
  await canvas.evaluate((element) => {
    element.style.outline = 'none';
  });
  await overlays.evaluateAll((elements) => {
    for (const element of elements) (element as HTMLElement).style.visibility = 'hidden';
  });
  const picture = PNG.sync.read(await page.locator('#viewport').screenshot());
  await overlays.evaluateAll((elements) => {
    for (const element of elements) (element as HTMLElement).style.visibility = '';
  });
  await canvas.evaluate((element) => {
    element.style.outline = '';
  });
  return picture;
}

/** The picture that the page saves. */
export async function savePicture(page: Page): Promise<PNG> {
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save PNG' }).last().click();
  return PNG.sync.read(await readFile(await (await download).path()));
}

/** The position of a light, by the label of its handle, after the next frame is drawn. */
export async function lampPlace(
  page: Page,
  selector = '#lamp',
): Promise<{ azimuth: number; elevation: number; distance: number }> {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  const text = (await page.locator(selector).getAttribute('aria-valuetext')) ?? '';
  const number = (pattern: RegExp): number => Number(pattern.exec(text)?.[1]);
  return {
    azimuth: number(/(-?[\d.]+)° around/),
    elevation: number(/(-?[\d.]+)° high/),
    distance: number(/([\d.]+) radii/),
  };
}

export interface Point {
  x: number;
  y: number;
}

/** The middle of an element in the page. */
export async function middleOf(page: Page, selector: string): Promise<Point> {
  const box = await page.locator(selector).boundingBox();
  expect(box, `${selector} is shown`).not.toBeNull();
  return { x: box!.x + box!.width / 2, y: box!.y + box!.height / 2 };
}

/** Drags a lamp with the mouse, in several steps. @param by in pixels */
export async function dragLamp(page: Page, by: Point, selector = '#lamp'): Promise<void> {
  const from = await middleOf(page, selector);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + by.x, from.y + by.y, { steps: 6 });
  await page.mouse.up();
  await ready(page);
}
