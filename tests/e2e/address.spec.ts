import type { Page } from '@playwright/test';
import { drop, middleOf, openPlayground, readDrawing, ready, writtenHash } from '../../tools/browser/playground.js';
import { file, octahedronPly } from '../../tools/modelFiles/modelFiles.js';
import { expect, readGlErrors, test } from '../browser/test.js';
import { changedShare } from './pictures.js';

test.use({ viewport: { width: 900, height: 420 } });

const LOOK = 'mapSize=64&mapTones=4&outlines=off&upAxis=z';
/** Pastes a link into the open page. */
async function follow(page: Page, hash: string): Promise<void> {
  await page.evaluate((link) => {
    location.hash = link;
  }, hash);
}

const modelAt = (path: string): string => encodeURIComponent(`https://models.test/${path}`);

test('a model by its address is fetched when the user has agreed, by the one page that may', async ({
  page,
  pageProblems,
}) => {
  const asked: string[] = [];
  await page.route('https://models.test/**', (route) => {
    const { pathname } = new URL(route.request().url());
    asked.push(pathname);
    const headers = { 'Access-Control-Allow-Origin': pathname === '/closed.ply' ? 'https://other.test' : '*' };
    if (pathname === '/missing.ply') return route.fulfill({ status: 404, headers });
    return route.fulfill({ body: file('octahedron.ply', octahedronPly).buffer, headers });
  });
  const name = page.locator('#model-name');
  const status = page.locator('#status');
  const question = page.getByRole('dialog', { name: /another site: models\.test File: octahedron\.ply Fetch it/ });
  const [yes, no] = [page.getByRole('button', { name: 'Fetch it' }), page.getByRole('button', { name: 'Leave it' })];

  await page.goto(`./#model=${modelAt('octahedron.ply')}&${LOOK}`);
  await expect(question).toBeVisible();
  await no.click();
  await expect(name).toHaveText('Stanford dragon');
  expect(asked).toEqual([]);
  await openPlayground(page, `model=cube&${LOOK}`);

  await follow(page, `model=${modelAt('octahedron.ply')}&${LOOK}`);
  await yes.click();
  await expect(name).toHaveText('octahedron.ply');
  expect(asked).toEqual(['/octahedron.ply']);
  const drawn = await readDrawing(page);
  // The link goes on naming it, and the browser keeps it: it is not fetched again.
  await expect.poll(() => page.evaluate(() => history.state?.drawing)).toBeTruthy();
  expect(page.url()).toContain(`model=${modelAt('octahedron.ply')}`);
  expect(page.url()).toContain('upAxis=z');
  await page.reload();
  await expect(name).toHaveText('octahedron.ply');
  expect(changedShare(drawn, await readDrawing(page))).toBe(0);
  expect(asked).toHaveLength(1);

  for (const [path, sentence] of [
    ['closed.ply', /does not let other pages fetch its files \(CORS\)\. Download it there, and drop it here\.$/],
    ['missing.ply', /^models\.test has no such file: it answered 404 for missing\.ply\.$/],
  ] as const) {
    await follow(page, `model=${modelAt(path)}&${LOOK}`);
    await yes.click();
    await expect(status).toHaveText(sentence);
    await expect(name).toHaveText('octahedron.ply');
  }
  // The browser says so, too.
  expect(pageProblems.splice(0).filter((problem) => !/CORS|ERR_FAILED|404/.test(problem))).toEqual([]);
  // The page itself may not: its policy is as it was.
  const isForbidden = await page.evaluate(() =>
    fetch('https://models.test/octahedron.ply').then(
      () => false,
      () => true,
    ),
  );
  expect(isForbidden).toBe(true);
  expect(asked).toHaveLength(3);
  expect(pageProblems.splice(0).join()).toMatch(/Content Security Policy/);
});

test('consent holds for one model on one site, whatever links and hasty clicks try', {
  tag: '@all',
}, async ({ page, pageProblems }) => {
  const asked: string[] = [];
  await page.route(/^https:/, (route) => {
    const { host, pathname } = new URL(route.request().url());
    asked.push(`${host}${pathname}`);
    const headers = { 'Access-Control-Allow-Origin': '*' };
    if (pathname === '/sent-on.ply') {
      return route.fulfill({ status: 302, headers: { ...headers, Location: 'https://evil.test/elsewhere.ply' } });
    }
    return route.fulfill({ body: file('octahedron.ply', octahedronPly).buffer, headers });
  });
  page.on('request', (request) => {
    if (request.redirectedFrom()) asked.push(request.url());
  });
  // A click that was on its way when the question came.
  await page.addInitScript(() => {
    const { showModal } = HTMLDialogElement.prototype;
    HTMLDialogElement.prototype.showModal = function () {
      showModal.call(this);
      this.querySelector<HTMLButtonElement>('[value=yes]')?.click();
    };
  });
  const ask = (address: string): Promise<void> => follow(page, `model=${encodeURIComponent(address)}&${LOOK}`);
  const question = page.getByRole('dialog');
  const [yes, no] = [page.getByRole('button', { name: 'Fetch it' }), page.getByRole('button', { name: 'Leave it' })];
  const name = page.locator('#model-name');
  const site = page.locator('.ask-site');

  await page.goto(`./#model=${encodeURIComponent('https://evil.test/track.ply')}&${LOOK}`);
  await expect(site).toHaveText('evil.test');
  await expect(no).toBeFocused();
  // A second question takes the place of the first: with "Yes" to it, nobody has agreed to the first.
  await ask('https://trusted.test/%E2%80%AEbunny.ply');
  await expect(site).toHaveText('trusted.test');
  await expect(question).toHaveCount(1);
  await expect(no).toBeFocused();
  await yes.click();
  await expect(name).toHaveText('bunny.ply');
  expect(asked).toEqual(['trusted.test/%E2%80%AEbunny.ply']);
  expect(await page.title()).toBe('bunny.ply, hatched');

  // The question is withdrawn when the address changes: by a link, and by Back.
  await ask('https://evil.test/track.ply');
  await expect(question).toBeVisible();
  await follow(page, `model=cube&${LOOK}`);
  await expect(question).toBeHidden();
  await expect(name).toHaveText('Cube');
  await ask('https://evil.test/track.ply');
  await expect(question).toBeVisible();
  await page.goBack();
  await expect(question).toBeHidden();
  // Two links at once, before the question about the first can be shown.
  await page.evaluate(
    (links) => {
      for (const link of links) location.hash = link;
    },
    [
      `model=${encodeURIComponent('https://evil.test/1.ply')}`,
      `model=${encodeURIComponent('https://evil.test/2.ply')}`,
    ],
  );
  await expect(page.locator('.ask-file')).toHaveText('File: 2.ply');
  await expect(question).toHaveCount(1);
  // Enter and Escape are "No", and who comes back to the window reads first.
  await page.evaluate(() => {
    dispatchEvent(new Event('focus'));
    document.querySelector<HTMLButtonElement>('#ask [value=yes]')?.click();
  });
  await page.keyboard.press('Enter');
  await expect(question).toBeHidden();
  await ask('https://evil.test/3.ply');
  await expect(question).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(question).toBeHidden();
  expect(asked).toHaveLength(1);
  // None of them is waited for any more.
  await ready(page);

  // The site is named as it is, on a line of its own; the file's name cannot speak for it.
  const long = `${'a'.repeat(60)}.`.repeat(4);
  for (const [address, shownSite, shownFile] of [
    [
      'https://xn--80ak6aa92e.com/%E2%80%AEmoc.elpmaxe%20morf%20,blg.nemow',
      'xn--80ak6aa92e.com',
      'moc.elpmaxe morf ,blg.nemow',
    ],
    ['https://аррӏе.com/a.glb', 'xn--80ak6aa92e.com', 'a.glb'],
    ['https://trusted.test:x@evil.test:8443/a.glb', 'evil.test:8443', 'a.glb'],
    ['https://trusted.test%2F@evil.test/a.glb', 'evil.test', 'a.glb'],
    [`https://${long}test/a.glb`, `${long}test`, 'a.glb'],
    [
      `https://evil.test/women.glb%0A${'from%20trusted.test%20'.repeat(150)}.glb`,
      'evil.test',
      /^File: women\.glb from.{1,30}….{1,30}\.glb$/,
    ],
  ] as const) {
    await ask(address);
    await expect(site).toHaveText(shownSite);
    await expect(page.locator('.ask-file')).toHaveText(
      typeof shownFile === 'string' ? `File: ${shownFile}` : shownFile,
    );
    await expect(no).toBeInViewport({ ratio: 1 });
  }
  await no.click();
  for (const address of [
    'data:,x',
    'blob:https://evil.test/1',
    `https://${long.repeat(2)}test/a.glb`,
    'http://evil.test/a',
  ]) {
    await ask(address);
    await expect(name).toHaveText('Stanford dragon');
    await expect(question).toHaveCount(0);
    await follow(page, `model=cube&${LOOK}`);
    await expect(name).toHaveText('Cube');
  }
  expect(asked).toHaveLength(1);

  // A site that was agreed to cannot send the visitor on to another.
  await ask('https://trusted.test/sent-on.ply');
  await yes.click();
  await expect(page.locator('#status')).toHaveText(
    /^sent-on\.ply did not come: trusted\.test redirects to another site/,
  );
  expect(asked.slice(1)).toEqual(['trusted.test/sent-on.ply']);
  expect(pageProblems.splice(0).filter((problem) => !/Content Security Policy|ERR_|CORS/.test(problem))).toEqual([]);
});

test('a failed request leaves no style, no axis and no picture behind', {
  tag: '@all',
}, async ({ page, pageProblems }) => {
  let release = (): void => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/dragon_vrip_res4\.ply.*\.gz$/, async (route) => {
    await held;
    await route.continue();
  });
  const status = page.locator('#status');
  await page.addInitScript(() => {
    Object.defineProperty(navigator, 'share', {
      value: async (data: ShareData) => void Object.assign(window, { shared: data }),
      configurable: true,
    });
  });
  // There is no drawing to save.
  await page.goto(`./#model=dragon4&${LOOK}`);
  await expect(status).toHaveText(/^Fetching the dragon/);
  // The progress of the map may replace the sentence until the map is loaded.
  await status.evaluate(
    (line, sentence) =>
      new Promise<void>((resolve) => {
        new MutationObserver(() => {
          if (line.textContent === sentence) resolve();
        }).observe(line, { childList: true, characterData: true, subtree: true });
        document.querySelector<HTMLElement>('#save-png')!.click();
      }),
    'There is no drawing to save yet.',
  );
  release();
  await ready(page);

  // A style whose drawing is cancelled is not the style of the page.
  const style = page.getByRole('combobox', { name: 'Style' });
  await page.getByRole('button', { name: 'More', exact: true }).click();
  // Pressed by the page itself: the map may be there before a test has found the button.
  await status.evaluate((line) => {
    new MutationObserver((_, observer) => {
      const cancel = document.querySelector<HTMLElement>('#cancel')!;
      if (line.textContent === '' || !cancel.checkVisibility()) return;
      observer.disconnect();
      cancel.click();
    }).observe(line, { childList: true, characterData: true, subtree: true });
  });
  await page.getByRole('combobox', { name: 'Tile size' }).selectOption('512 px');
  await expect(status).toHaveText('Cancelled; the drawing is as it was.');
  await expect(page.getByRole('combobox', { name: 'Tile size' })).toHaveValue('64 px');
  await expect(style).toHaveValue('Hatching');
  expect(await writtenHash(page)).toContain('mapSize=64');

  // A link that is pasted brings its own axis, also to another model.
  await follow(page, `model=cube&${LOOK}`);
  await expect(page.locator('#model-name')).toHaveText('Cube');
  expect(await writtenHash(page)).toContain('upAxis=z');

  // A link that is followed just when the page would write its address is not written over.
  await page.getByRole('button', { name: 'Stipple' }).evaluate((button: HTMLElement, link) => {
    button.click();
    location.hash = link;
    dispatchEvent(new Event('pagehide'));
  }, `model=sphere&${LOOK}`);
  await expect(page.locator('#model-name')).toHaveText('Sphere');
  await follow(page, `model=cube&${LOOK}`);
  await expect(page.locator('#model-name')).toHaveText('Cube');

  // The system's sheet gets what the address would be.
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  await page.getByRole('button', { name: 'Share this drawing' }).click();
  // The code for sharing is fetched by the first click.
  await expect
    .poll(() => page.evaluate(() => (window as unknown as { shared?: ShareData }).shared))
    .toEqual({ title: 'Cube, hatched', url: expect.stringContaining('#model=cube&') });

  // A browser that lets nobody write the address says so, once, and keeps drawing; a link is there as long as there is a clipboard.
  await page.evaluate(() => {
    History.prototype.replaceState = () => {
      throw new DOMException('It was called too often.', 'SecurityError');
    };
    Object.defineProperty(navigator, 'clipboard', { value: undefined });
  });
  await page.getByRole('button', { name: 'Stipple' }).click();
  await expect(status).toHaveText(/^This browser does not let the page write its address/);
  await page.getByRole('button', { name: 'Copy a link to this drawing' }).click();
  await expect(status).toHaveText(/neither use the clipboard nor write its address/);
  await page.getByRole('button', { name: 'Pen', exact: true }).click();
  await ready(page);
  await expect(status).toHaveText('');

  // A page that cannot fetch what asks the user says so, draws, and goes on writing its address.
  await page.route(/\/assets\/(ask|LinkFollower)-/, (route) => route.abort());
  await page.goto('about:blank');
  await page.goto(`./#model=${modelAt('octahedron.ply')}&${LOOK}`);
  await expect(status).toHaveText(/^A part of this page could not be fetched/);
  await expect(page.locator('#model-name')).toHaveText('Stanford dragon');
  await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/^#model=dragon3&technique=hatching&/);
  await drop(page, [file('octahedron.ply', octahedronPly)]);
  await expect(page.locator('#model-name')).toHaveText('octahedron.ply');
  await expect(status).toHaveText('');
  await drop(page, [file('stray.png', 'x')]);
  await expect(status).toHaveText(/^A part of this page could not be fetched/);
  // Prefetches are refused too, and would be reported after the test has checked.
  expect(await readGlErrors(page)).toEqual([]);
  await page.close();
  expect(pageProblems.splice(0).filter((problem) => !/ERR_FAILED/.test(problem))).toEqual([]);
});

test("a link draws the same picture as its sender's page: orbited, and framed before the light was moved", {
  tag: '@all',
}, async ({ page }) => {
  const sent = async (): Promise<void> => {
    const drawn = await readDrawing(page);
    const written = await writtenHash(page);
    await page.goto('about:blank');
    await openPlayground(page, written.slice(1));
    expect(changedShare(drawn, await readDrawing(page))).toBe(0);
    expect(await writtenHash(page)).toBe(written);
  };
  const link = 'technique=engraving&model=knot&shadows=on&ground=shadow&lightAzimuth=-80&lightElevation=20';
  await openPlayground(page, link);
  await page.locator('#lamp').focus();
  // To the other side, where the shadow needs room.
  for (let i = 0; i < 30; i++) await page.keyboard.press('ArrowRight');
  expect(await writtenHash(page)).toMatch(/lightAzimuth=70&.*camera=/);
  await sent();

  const { x, y } = await middleOf(page, '#viewport');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 67, y + 21, { steps: 7 });
  await page.mouse.up();
  await page.mouse.wheel(0, -130);
  await sent();
});
