import type { Page } from '@playwright/test';
import { openPlayground, readDrawing } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';
import { cases } from '../selection.mjs';
import { TYPEWRITER, widenLetters } from './wideLetters.js';

const WIDTHS = [320, 375, 600, 820, 1000, 1280, 1920, 3840];
/** Space added to each letter. */
const SPACINGS = ['0', TYPEWRITER];

/** Faults of the frame around the drawing: cut off, outside the window, or over its neighbour. */
function findFaults(): string[] {
  const faults: string[] = [];
  const nameOf = (element: Element) =>
    `${element.id || element.className} "${element.textContent?.trim().slice(0, 24)}"`;
  const middleOf = ({ left, right, top, bottom }: DOMRect) => ({ x: (left + right) / 2, y: (top + bottom) / 2 });
  const shown = (selector: string) =>
    [...document.querySelectorAll<HTMLElement>(selector)].filter((element) => element.checkVisibility());
  const groups = [
    '.bar > *',
    '.presets > *',
    '.caption > *',
    '.card-head > *',
    '.lil-controller',
    '.lil-controller > *',
  ];
  for (const selector of groups) {
    const elements = shown(selector);
    const boxes = elements.map((element) => element.getBoundingClientRect());
    elements.forEach((element, i) => {
      const { left, right } = boxes[i];
      if (left < -0.5 || right > innerWidth + 0.5) faults.push(`${nameOf(element)} sticks out`);
      if (element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0)
        faults.push(`${nameOf(element)} is cut off at the side`);
      if (element.matches('button, a, p') && element.scrollHeight > element.clientHeight + 1)
        faults.push(`${nameOf(element)} is cut off below`);
      for (let j = 0; j < i; j++) {
        if (elements[j].parentElement !== element.parentElement) continue;
        const a = boxes[i];
        const b = boxes[j];
        const over = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (over > 1 && down > 1 && a.width > 0 && b.width > 0)
          faults.push(`${nameOf(element)} lies over ${nameOf(elements[j])}`);
      }
    });
  }
  for (const card of shown('.card')) {
    if (card.scrollHeight > card.clientHeight + 1 && getComputedStyle(card).overflowY === 'visible')
      faults.push(`${nameOf(card)} holds more than it shows`);
  }
  const rows = new Set(shown('.bar > *').map((element) => Math.round(middleOf(element.getBoundingClientRect()).y)));
  // The narrowest phones, or other letters than usual, may need a second one.
  const isUsual =
    matchMedia('(min-width: 23em)').matches && !(Number.parseFloat(getComputedStyle(document.body).letterSpacing) > 0);
  if (rows.size > 1 && (isUsual || matchMedia('(min-width: 51.25em)').matches)) faults.push('the bar takes two rows');
  for (const element of shown('[hidden]')) faults.push(`${nameOf(element)} shows, though it is hidden`);
  const { scrollWidth } = document.documentElement;
  if (scrollWidth > innerWidth) faults.push(`the page is ${scrollWidth} pixels wide`);
  return faults;
}

/** Unusable controls: those that no scrolling brings into the window, or that are covered. */
function findUnreachable(): string[] {
  const faults: string[] = [];
  const all = document.querySelectorAll<HTMLElement>('button, summary, a[href], select, input, [tabindex="0"]');
  for (const element of all) {
    if (!element.checkVisibility() || element.closest('.visually-hidden, :disabled')) continue;
    element.scrollIntoView({ block: 'nearest' });
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    const hit = document.elementFromPoint(x, y);
    // The lamp and the sentences about the drawing lie over it.
    if (hit && (element.contains(hit) || element.id === 'drawing')) continue;
    const over = hit ? `under ${hit.id || hit.className || hit.tagName}` : 'outside of the window';
    faults.push(`${element.id || element.className} "${element.textContent?.trim().slice(0, 24)}" is ${over}`);
  }
  return faults;
}

/** Opens the settings, where they are closed, and every fold of them. */
async function openAll(page: Page): Promise<void> {
  const toggle = page.getByRole('button', { name: 'Settings' });
  if ((await toggle.isVisible()) && (await toggle.getAttribute('aria-expanded')) === 'false') await toggle.click();
  await page.evaluate(() => {
    // A user's own model makes the bar as full as it gets.
    document.getElementById('open-recent')!.hidden = false;
    for (const title of document.querySelectorAll<HTMLElement>('.lil-gui .lil-closed > .lil-title')) title.click();
  });
}

test('nothing overlaps, is cut off or sticks out, at eight widths and with wide letters', { tag: '@more' }, async ({
  page,
}) => {
  await page.setViewportSize({ width: 1000, height: 500 });
  await openPlayground(page, 'model=cube&mapSize=64&mapTones=4&outlines=off');
  for (const spacing of cases(SPACINGS.slice(0, 1), SPACINGS)) {
    await widenLetters(page, spacing);
    for (const width of cases([320, 1000], WIDTHS)) {
      await page.setViewportSize({ width, height: 500 });
      await openAll(page);
      expect.soft(await page.evaluate(findFaults), `${width} pixels, ${spacing} more to a letter`).toEqual([]);
    }
  }
});

test.describe('at 200 %', () => {
  test.use({ deviceScaleFactor: 2, viewport: { width: 640, height: 512 } });

  test('nothing is cut off or out of reach: the page twice as large, or its letters alone', { tag: '@all' }, async ({
    page,
  }) => {
    await openPlayground(page, 'model=cube&mapSize=64&mapTones=4&outlines=off');
    // Windows of 1,280 × 1,024, 1,366 × 768 and 1,920 × 1,080 pixels: what is left of them at twice the size.
    for (const [width, height] of [
      [640, 512],
      [683, 384],
      [960, 540],
    ]) {
      await page.setViewportSize({ width, height });
      await openAll(page);
      const faults = [...(await page.evaluate(findFaults)), ...(await page.evaluate(findUnreachable))];
      expect.soft(faults, `${width} × ${height}, twice as large`).toEqual([]);
    }
    // Letters twice as large as usual, as a browser can be set to.
    const session = await page.context().newCDPSession(page);
    await session.send('Page.setFontSizes', { fontSizes: { standard: 32, fixed: 26 } });
    for (const [width, height] of [
      [1280, 1024],
      [1920, 1080],
      [640, 1024],
    ]) {
      await page.setViewportSize({ width, height });
      await openAll(page);
      const faults = [...(await page.evaluate(findFaults)), ...(await page.evaluate(findUnreachable))];
      expect.soft(faults, `${width} × ${height}, large letters`).toEqual([]);
    }
  });
});

const LOW =
  'model=dragon4&technique=engraving&outlines=off&occlusion=0&shadows=on&ground=shadow&lightElevation=12&lightAzimuth';
for (const [name, hash] of [
  ['of the first picture', ''],
  ['under a low light from the left', `${LOW}=-90`],
  ['under a low light from the right', `${LOW}=90`],
]) {
  test.describe('on a phone', () => {
    test.use({ viewport: { width: 390, height: 844 } });

    test(`the shadow on the ground ends on the sheet: ${name}`, { tag: '@all' }, async ({ page }) => {
      await openPlayground(page, hash);
      const { data, width, height } = await readDrawing(page);
      const paper = data[0];
      let [inked, atEdge] = [0, 0];
      for (let i = 0; i < width * height; i++) {
        if (data[4 * i] > paper - 24) continue;
        inked++;
        const x = i % width;
        if (Math.min(x, width - 1 - x) < 2) atEdge++;
      }
      expect(inked).toBeGreaterThan(5000);
      expect(atEdge).toBe(0);
    });
  });
}
