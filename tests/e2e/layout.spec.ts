import { expect, test } from '../browser/test.js';
import { openPlayground } from './playground.js';

const WIDTHS = [320, 375, 600, 820, 1000, 1280, 1920, 3840];
/** That of the page, a wide one and a very wide one. */
const FONTS = ['', 'DejaVu Serif', 'DejaVu Sans Mono'];

/** What is wrong with the frame around the drawing: cut off, outside of the window, or over its neighbour. */
function findFaults(): string[] {
  const faults: string[] = [];
  const nameOf = (element: Element) =>
    `${element.id || element.className} "${element.textContent?.trim().slice(0, 24)}"`;
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
  for (const element of shown('[hidden]')) faults.push(`${nameOf(element)} shows, though it is hidden`);
  const { scrollWidth } = document.documentElement;
  if (scrollWidth > innerWidth) faults.push(`the page is ${scrollWidth} pixels wide`);
  return faults;
}

test('nothing overlaps, is cut off or sticks out, at eight widths and in three fonts', async ({ page }) => {
  await page.setViewportSize({ width: 1000, height: 500 });
  await openPlayground(page, 'model=cube&lines=off');
  for (const font of FONTS) {
    await page.evaluate((name) => {
      if (name) document.body.style.setProperty('--serif', `"${name}"`);
      document.body.style.fontFamily = 'var(--serif)';
    }, font);
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 500 });
      const toggle = page.getByRole('button', { name: 'Settings' });
      if ((await toggle.isVisible()) && (await toggle.getAttribute('aria-expanded')) === 'false') await toggle.click();
      expect.soft(await page.evaluate(findFaults), `${width} pixels, ${font || 'the font of the page'}`).toEqual([]);
    }
  }
});
