import { fileURLToPath } from 'node:url';
import type { Locator, Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { buildExamples } from '../../examples/build.mjs';
import { readExamples } from '../../examples/readExamples.mjs';
import { refreshes } from '../../tools/browser/playground.js';
import { serveFolders } from '../../tools/browser/serveFolders.js';
import { toleratedMessages } from '../../tools/browser/toleratedMessages.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { octahedronDracoGlb, octahedronMeshoptGlb } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { ktx2Picture } from './ktx2Picture.js';
import { changedShare, meanInk } from './pictures.js';

const EXAMPLES = readExamples();
/** Examples that `npm test` draws: a mesh alone, one that changes in every way, and one that uses workers. */
const QUICK = ['one-mesh', 'configurator', 'strict-csp'];

const folder = fileURLToPath(new URL('../output/examples', import.meta.url));
const three = fileURLToPath(new URL('../../node_modules/three', import.meta.url));

let server: Awaited<ReturnType<typeof serveFolders>>;

// The examples as deployed: built, in a folder of a host.
test.beforeAll(async () => {
  await buildExamples(folder);
  server = await serveFolders({ '/some/folder/': folder, '/three/': three });
});
test.afterAll(() => server.close());

test.use({ viewport: { width: 320, height: 480 } });

const read = async (place: Locator): Promise<PNG> => PNG.sync.read(await place.screenshot());

/** The shares of dark pixels, of light pixels, and of changes between them along rows. */
function measure({ data, width, height }: Pick<PNG, 'data' | 'width' | 'height'>) {
  const light = (i: number) => (0.2126 * data[i] + 0.7152 * data[i + 1] + 0.0722 * data[i + 2]) / 255;
  const counts = { dark: 0, bright: 0, edges: 0 };
  for (let i = 0; i < data.length; i += 4) {
    if (light(i) < 0.4) counts.dark++;
    if (light(i) > 0.7) counts.bright++;
    if ((i / 4) % width < width - 1 && Math.abs(light(i) - light(i + 4)) > 0.2) counts.edges++;
  }
  return Object.fromEntries(Object.entries(counts).map(([name, count]) => [name, count / (width * height)]));
}

/** Waits until there is a drawing: ink, paper, and strokes. */
async function drawn(place: Locator): Promise<PNG> {
  let picture: PNG | undefined;
  await expect
    .poll(
      async () => {
        picture = await read(place);
        const { dark, bright, edges } = measure(picture);
        return dark > 0.02 && bright > 0.02 && edges > 0.012;
      },
      { timeout: 60_000, message: 'a drawing of ink and paper' },
    )
    .toBe(true);
  return picture!;
}

/** Notes what a page says and where it asks, which should be nothing, and nowhere else. */
function listen(page: Page): string[] {
  const heard: string[] = [];
  page.on('console', (message) => {
    if (!toleratedMessages.some(({ pattern }) => pattern.test(message.text()))) heard.push(message.text());
  });
  page.on('request', (request) => {
    if (!request.url().startsWith(server.url) && !/^(blob|data):/.test(request.url())) heard.push(request.url());
  });
  return heard;
}

for (const example of EXAMPLES) {
  test(`the example "${example.title}" is drawn, beside its source`, {
    tag: QUICK.includes(example.folder) ? [] : ['@all'],
  }, async ({ page }) => {
    const heard = listen(page);
    const workers: string[] = [];
    page.on('worker', (worker) => workers.push(worker.url()));
    await page.goto(`${server.url}/some/folder/${example.folder}/index.html`);
    const picture = await drawn(page.locator('.picture'));
    await test.info().attach(example.folder, { body: PNG.sync.write(picture), contentType: 'image/png' });
    await expect(page.locator('.source')).toContainText("'three-hatching");
    await expect(page.getByRole('heading', { level: 1 })).toHaveText(example.title);

    if (example.folder === 'animated-model') {
      await expect.poll(async () => changedShare(picture, await read(page.locator('.picture')))).toBeGreaterThan(0.01);
    }
    if (example.folder === 'strict-csp') {
      expect(workers.length).toBeGreaterThan(0);
      expect(workers.filter((address) => !address.startsWith(server.url))).toEqual([]);
    }
    if (example.folder === 'print') {
      const download = page.waitForEvent('download');
      await page.getByRole('button').click();
      const chunks = await (await (await download).createReadStream()).toArray();
      const print = PNG.sync.read(Buffer.concat(chunks));
      expect([print.width, print.height]).toEqual([1181, 886]);
      expect(measure(print).edges).toBeGreaterThan(0.01);
    }
    if (example.folder === 'configurator') {
      const changes = async (act: () => Promise<unknown>, least: number) => {
        const before = await read(page.locator('canvas'));
        await act();
        await expect
          .poll(async () => changedShare(before, await read(page.locator('canvas'))), { timeout: 30_000 })
          .toBeGreaterThan(least);
      };
      await changes(() => page.getByLabel('Cord').uncheck(), 0.002);
      await changes(() => page.getByLabel('Colour').fill('#802010'), 0.01);
      await changes(() => page.getByLabel('Opacity').fill('0.3'), 0.01);
      await changes(() => page.getByLabel('Shade').selectOption('globe'), 0.02);
      await changes(async () => {
        await page.getByLabel('Look').selectOption('engraving');
        await page.getByLabel('Look').selectOption('chalk');
      }, 0.5);
      const download = page.waitForEvent('download');
      await page.getByRole('button', { name: 'Save PNG' }).click();
      const chunks = await (await (await download).createReadStream()).toArray();
      const { data } = PNG.sync.read(Buffer.concat(chunks));
      const opacities = new Set(data.filter((_, i) => i % 4 === 3));
      expect([opacities.has(0), opacities.has(255)]).toEqual([true, true]);
      await page.getByRole('button', { name: 'Free all' }).click();
    }
    if (example.folder === 'own-hand') {
      const swatch = (await page.locator('.swatch').boundingBox())!;
      for (let i = 0; i < 5; i++) {
        const [x, y] = [swatch.x + 20, swatch.y + 20 + 14 * i];
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 90, y + 6, { steps: 6 });
        await page.mouse.up();
      }
      // The strokes on the swatch alone change less than 2 % of the picture.
      await expect.poll(async () => changedShare(picture, await read(page.locator('.picture')))).toBeGreaterThan(0.05);
    }
    if (example.folder === 'vector-file') {
      const download = page.waitForEvent('download');
      await page.getByRole('button').click();
      const chunks = await (await (await download).createReadStream()).toArray();
      const svg = Buffer.concat(chunks).toString();
      expect(svg).toContain('width="120mm" height="90mm"');
      expect(svg.match(/<path/g)?.length).toBeGreaterThan(200);
    }
    expect(heard).toEqual([]);
  });
}

test('the page of all examples shows and links each', { tag: '@all' }, async ({ page }) => {
  const heard = listen(page);
  await page.goto(`${server.url}/some/folder/index.html`);
  const pictures = page.locator('.gallery img');
  await expect(pictures).toHaveCount(EXAMPLES.length);
  for (const picture of await pictures.all()) {
    await picture.scrollIntoViewIfNeeded();
    await expect.poll(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBe(480);
  }
  const addresses = await page
    .locator('.gallery a')
    .evaluateAll((links) => links.map((link) => link.getAttribute('href')));
  expect(addresses).toEqual(EXAMPLES.map(({ folder }) => `./${folder}/`));
  expect(heard).toEqual([]);
});

test.describe('<hatched-model>', () => {
  // Small, because each test draws its pictures many times.
  const viewport = { width: 320, height: 480 };
  test.use({ viewport });

  const elements = (page: Page) => page.locator('hatched-model');
  const contexts = (page: Page) =>
    page.evaluate(() => window.__webglContexts!.map((context) => (context.isContextLost() ? 'lost' : 'there')));

  async function openElements(page: Page): Promise<Locator> {
    await page.goto(`${server.url}/some/folder/web-component/page.html`);
    await expect(page.locator('hatched-model canvas[data-drawn]')).toHaveCount(3, { timeout: 60_000 });
    return elements(page).first();
  }

  /** The drawing alone, without the frame of the focus. */
  const pixels = async (canvas: Locator): Promise<PNG> => {
    const address = await canvas.evaluate((element: HTMLCanvasElement) => element.toDataURL());
    return PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
  };

  // The page loads three models whenever it is opened, so the test opens it rarely.
  test('turns by keys and by hand, draws as its attributes say and only then, and has strokes as wide on a dense screen', {
    tag: '@all',
  }, async ({ page }) => {
    test.slow();
    const first = await openElements(page);
    expect(await contexts(page)).toEqual(['there']);
    const fetched = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
    expect(fetched.filter((address) => /element\.js|decoder/i.test(address))).toEqual([
      expect.stringMatching(/\/element\.js$/),
    ]);
    const plain = await pixels(first.locator('canvas'));

    await test.step('turns by keys and by hand, and draws only then', async () => {
      const canvas = page.getByRole('img', { name: 'A jug and fruit in pen and ink' });
      await canvas.focus();
      const home = await pixels(canvas);
      for (const key of ['ArrowLeft', 'Shift+ArrowRight', '+']) {
        await page.keyboard.press(key);
        await expect.poll(async () => changedShare(home, await pixels(canvas)), { message: key }).toBeGreaterThan(0.02);
        await page.keyboard.press('Home');
        await expect.poll(async () => changedShare(home, await pixels(canvas))).toBeLessThan(0.005);
      }
      const { x, y, width, height } = (await first.boundingBox())!;
      for (const button of ['left', 'right'] as const) {
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down({ button });
        await page.mouse.move(x + 0.7 * width, y + 0.4 * height, { steps: 3 });
        await page.mouse.up({ button });
        await expect
          .poll(async () => changedShare(home, await pixels(canvas)), { message: button })
          .toBeGreaterThan(0.02);
        await page.keyboard.press('Home');
        await expect.poll(async () => changedShare(home, await pixels(canvas))).toBeLessThan(0.005);
      }
      // No frame is drawn without a change.
      await page.evaluate(() => {
        const { drawImage } = CanvasRenderingContext2D.prototype;
        const counted = window as unknown as { frames: number };
        counted.frames = 0;
        CanvasRenderingContext2D.prototype.drawImage = function (this: CanvasRenderingContext2D, ...args: unknown[]) {
          counted.frames++;
          return drawImage.apply(this, args as Parameters<typeof drawImage>);
        } as typeof drawImage;
      });
      await refreshes(page, 10);
      expect(await page.evaluate(() => (window as unknown as { frames: number }).frames)).toBe(0);
      await first.evaluate((element) => element.setAttribute('light', '70, 20'));
      await expect.poll(async () => changedShare(home, await pixels(canvas))).toBeGreaterThan(0.02);
      expect(await page.evaluate(() => (window as unknown as { frames: number }).frames)).toBeLessThan(4);
    });

    // The first picture again.
    await first.evaluate((element) => element.removeAttribute('light'));
    await expect.poll(async () => changedShare(plain, await pixels(first.locator('canvas')))).toBeLessThan(0.005);

    await test.step('draws lighter, paler at the rim, and dark colours white, as its attributes say', async () => {
      const ink = async (at: number): Promise<number> =>
        meanInk(await pixels(elements(page).nth(at).locator('canvas')));
      const set = (at: number, name: string, value: string) =>
        elements(page)
          .nth(at)
          .evaluate((element, [attribute, text]) => element.setAttribute(attribute, text), [name, value] as const);
      const [jug, fish] = [0, 1];
      const usual = await ink(jug);
      const models = (): Promise<number> =>
        page.evaluate(
          () => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('.glb')).length,
        );
      const loaded = await models();
      expect(loaded).toBeGreaterThan(0);
      await set(jug, 'exposure', '1.6');
      await expect.poll(() => ink(jug)).toBeLessThan(0.9 * usual);
      await set(jug, 'exposure', '1');
      await expect.poll(() => ink(jug)).toBeCloseTo(usual, 4);
      await set(jug, 'vignette', '1');
      await expect.poll(() => ink(jug)).toBeLessThan(0.95 * usual);
      // The eyes of the fish are black.
      const hatched = await ink(fish);
      await set(fish, 'color-hatching', '0');
      await expect.poll(() => ink(fish)).toBeLessThan(hatched - 5e-5);
      await set(fish, 'color-fill', '1');
      await expect.poll(() => ink(fish)).toBeGreaterThan(hatched);
      await set(jug, 'preset', 'woodcut');
      await expect.poll(() => ink(jug)).toBeGreaterThan(1.2 * usual);
      // Other looks load no model again.
      expect(await models()).toBe(loaded);
    });

    await test.step('has strokes as wide on a dense screen', async () => {
      const screen = await page.context().newCDPSession(page);
      await screen.send('Emulation.setDeviceMetricsOverride', { ...viewport, deviceScaleFactor: 2, mobile: false });
      const dense = await pixels((await openElements(page)).locator('canvas'));
      expect([dense.width, dense.height]).toEqual([2 * plain.width, 2 * plain.height]);
      // Where four neighbouring pixels of one picture are ink the other has ink, and the same for paper.
      let same = 0;
      let opposite = 0;
      for (let i = 0; i < plain.width * plain.height; i++) {
        const [x, y] = [2 * (i % plain.width), 2 * Math.floor(i / plain.width)];
        const four = [0, 1, dense.width, dense.width + 1].map((next) => dense.data[4 * (y * dense.width + x + next)]);
        const isInk = plain.data[4 * i] < 128;
        if (four.every((red) => red < 100 || red > 156) && new Set(four.map((red) => red < 128)).size === 1) {
          if (four[0] < 128 === isInk) same++;
          else opposite++;
        }
      }
      // Strokes of a pen that taper to less than a pixel end in other places.
      expect(opposite / same).toBeLessThan(0.012);
    });
  });

  test('can be moved, removed and added again, and frees the context with the last one; reports errors, shows its poster until then, and loads when it comes into view', {
    tag: '@all',
  }, async ({ page, pageProblems }) => {
    test.slow();
    await test.step('bears being moved, taken out and put back, and frees the context with the last', async () => {
      await openElements(page);
      const answer = await page.evaluate(async () => {
        const all = [...document.querySelectorAll('hatched-model')] as HTMLElement[];
        const main = document.querySelector('main')!;
        const lost = () => window.__webglContexts!.map((context) => context.isContextLost());
        const tasks = () => new Promise((resolve) => setTimeout(resolve));
        const isDrawn = (element: HTMLElement) =>
          element.shadowRoot!.querySelector('canvas')!.dataset.drawn !== undefined;
        main.append(all[0]);
        await tasks();
        const afterMove = all.map(isDrawn);
        for (const element of all.slice(1)) element.remove();
        await tasks();
        const afterTwo = [all.map(isDrawn), lost()];
        all[0].remove();
        await tasks();
        const afterAll = [all.map(isDrawn), lost()];
        const loaded = Promise.all(
          all.map((element) => new Promise((resolve) => element.addEventListener('load', resolve))),
        );
        main.append(...all);
        await loaded;
        return { afterMove, afterTwo, afterAll };
      });
      expect(answer.afterMove).toEqual([true, true, true]);
      expect(answer.afterTwo).toEqual([[true, false, false], [false]]);
      expect(answer.afterAll).toEqual([[false, false, false], [true]]);
      await expect(page.locator('hatched-model canvas[data-drawn]')).toHaveCount(3, { timeout: 60_000 });
      await drawn(elements(page).first());
      expect(await contexts(page)).toEqual(['lost', 'there']);
    });

    await test.step('says what is wrong, shows its poster until then, and loads what comes into view', async () => {
      const say = async (attributes: Record<string, string>) =>
        elements(page)
          .last()
          .evaluate(async (element, values) => {
            const failed = new Promise<string>((resolve) =>
              element.addEventListener('error', (event) => resolve((event as ErrorEvent).message), { once: true }),
            );
            for (const [name, value] of Object.entries(values)) element.setAttribute(name, value);
            return failed;
          }, attributes);
      const sentence = 'The model "none.glb" could not be fetched: the server answered 404.';
      expect(await say({ src: 'none.glb' })).toBe(sentence);
      await expect(page.getByRole('alert')).toHaveText(sentence);
      expect(pageProblems.splice(0).join()).toContain('404');
      expect(await say({ src: '../models/fish.glb', preset: 'oils' })).toMatch(
        /^There is no preset "oils"\. There are pen, /,
      );
      expect(await say({ light: 'left' })).toMatch(/^The light is "left", but must be/);
      // A right preset does not help while the light is wrong; a right light does.
      expect(await say({ preset: 'stipple' })).toMatch(/^The light is "left"/);
      await elements(page)
        .last()
        .evaluate((element) => Object.assign(element, { light: '0 60' }));
      await expect(page.getByRole('alert')).toHaveCount(0, { timeout: 60_000 });

      const asked: string[] = [];
      page.on('request', (request) => asked.push(request.url()));
      await page.evaluate(() => {
        document.body.style.paddingBottom = '4000px';
        const late = Object.assign(document.createElement('hatched-model'), {
          src: '../models/fish.glb?late',
          poster: '../animated-model/picture.webp',
          alt: 'late',
        });
        late.style.cssText = 'position: absolute; top: 3000px; width: 200px; height: 150px';
        document.body.append(late);
      });
      const late = elements(page).last();
      await expect.poll(() => late.locator('img').evaluate((image: HTMLImageElement) => image.naturalWidth)).toBe(480);
      // Frames enough for the page to know what is in view.
      for (let i = 0; i < 3; i++) await page.evaluate(() => new Promise(requestAnimationFrame));
      expect(asked.filter((address) => address.endsWith('?late'))).toEqual([]);
      await late.scrollIntoViewIfNeeded();
      await expect(late.locator('canvas[data-drawn]')).toHaveCount(1, { timeout: 60_000 });
      await expect(late.locator('img')).toBeHidden();
    });
  });

  const libs = '/three/examples/jsm/libs';

  /** Opens a page with models, each packed in another way, and says what it asks for. */
  async function openPacked(page: Page, headers: Record<string, string> = {}): Promise<string[]> {
    const basisu = { extensionsUsed: ['KHR_texture_basisu'], extensionsRequired: ['KHR_texture_basisu'] };
    const texture = (ktx2: number, other?: number): object => ({
      sampler: 0,
      source: other,
      extensions: { KHR_texture_basisu: { source: ktx2 } },
    });
    const files: Record<string, Buffer> = {
      'draco.glb': await octahedronDracoGlb(),
      'damaged.glb': Buffer.from((await octahedronDracoGlb()).toString('latin1').replace('DRACO', 'Draco'), 'latin1'),
      'meshopt.glb': await octahedronMeshoptGlb(),
      'ktx2.glb': columnGlb({
        still: true,
        picture: ktx2Picture([
          [255, 0, 0],
          [0, 0, 255],
        ]),
        changes: ({ images }) => ({
          ...basisu,
          images: [{ ...(images as object[])[0], mimeType: 'image/ktx2' }],
          textures: [texture(0)],
        }),
      }),
      // One picture is missing, another is there.
      'both.glb': columnGlb({
        still: true,
        changes: ({ images }) => ({
          extensionsUsed: ['KHR_texture_basisu'],
          images: [...(images as object[]), { uri: 'none.ktx2', mimeType: 'image/ktx2' }],
          textures: [texture(1, 0)],
        }),
      }),
    };
    const imports = {
      three: '/three/build/three.module.js',
      'three/addons/': '/three/examples/jsm/',
      'three-hatching/element': '/some/folder/lib/three-hatching/dist/element.js',
    };
    const html = `<!doctype html><title>Packed</title><link rel="icon" href="data:," />
      <style>hatched-model { width: 200px; height: 150px }</style>
      <script type="importmap">${JSON.stringify({ imports })}</script>
      <script type="module">import 'three-hatching/element';</script>
      ${['draco', 'draco', 'ktx2', 'meshopt'].map((name) => `<hatched-model src="${name}.glb" color-fill="1" alt="${name}"></hatched-model>`).join('')}`;
    await page.route(`${server.url}/packed/**`, (route) => {
      const name = new URL(route.request().url()).pathname.replace('/packed/', '');
      // Hosts of single-page applications serve the page for missing files.
      return name in files
        ? route.fulfill({ body: files[name] })
        : route.fulfill({ contentType: 'text/html; charset=utf-8', headers, body: html });
    });
    await page.addInitScript(() => {
      const decoders: Decoders = { started: [], running: 0 };
      Object.assign(window, { decoders });
      const own = new WeakSet<Worker>();
      const { postMessage, terminate } = Worker.prototype;
      Worker.prototype.postMessage = function (this: Worker, ...args: unknown[]) {
        const [message] = args as [{ type?: string; decoderConfig?: object }];
        if (message.type === 'init') {
          own.add(this);
          decoders.running++;
          decoders.started.push(message.decoderConfig ? 'draco' : 'ktx2');
        }
        postMessage.apply(this, args as Parameters<typeof postMessage>);
      };
      Worker.prototype.terminate = function (this: Worker) {
        if (own.has(this)) decoders.running--;
        terminate.call(this);
      };
    });
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url().replace(server.url, '')));
    await page.goto(`${server.url}/packed/`);
    return asked;
  }

  /** The shares of red and of blue paper in a picture. */
  function hues({ data }: PNG): { red: number; blue: number } {
    const counts = { red: 0, blue: 0 };
    for (let i = 0; i < data.length; i += 4) {
      if (data[i] - data[i + 2] > 100) counts.red++;
      if (data[i + 2] - data[i] > 100) counts.blue++;
    }
    return { red: (4 * counts.red) / data.length, blue: (4 * counts.blue) / data.length };
  }

  test('reads models that are packed, with decoders of its own host, which are fetched for them and end with the loading', {
    tag: '@all',
  }, async ({ page, pageProblems }) => {
    const asked = await openPacked(page);
    const [draco, , ktx2, meshopt] = await elements(page).all();
    const alert = page.getByRole('alert');
    await expect(alert).toHaveText([
      ...Array(2).fill(
        'The model "draco.glb" could not be read: it is packed with Draco, and the attribute draco-path must name the folder of its decoder.',
      ),
      'The model "ktx2.glb" could not be read: its pictures are packed as KTX2, and the attribute ktx2-path must name the folder of its decoder.',
    ]);
    await expect(meshopt.locator('canvas[data-drawn]')).toHaveCount(1, { timeout: 60_000 });
    expect(measure(await read(meshopt)).edges).toBeGreaterThan(0.01);
    expect(asked.filter((address) => /DRACO|KTX2|ktx-parse|\/(draco|basis)\//.test(address))).toEqual([]);

    // A folder with and without its final slash.
    await elements(page).evaluateAll((all, path) => {
      Object.assign(all[0], { dracoPath: `${path}/draco/gltf` });
      all[1].setAttribute('draco-path', `${path}/draco/gltf/`);
      all[2].setAttribute('ktx2-path', `${path}/basis/`);
    }, libs);
    await expect(page.locator('hatched-model canvas[data-drawn]')).toHaveCount(4, { timeout: 60_000 });
    await expect(alert).toHaveCount(0);
    expect(hues(await read(draco)).red).toBeGreaterThan(0.05);
    const { red, blue } = hues(await read(ktx2));
    expect(Math.min(red, blue)).toBeGreaterThan(0.02);
    const decoders = await page.evaluate(() => (window as unknown as { decoders: Decoders }).decoders);
    expect(decoders).toEqual({ started: expect.arrayContaining(['draco', 'ktx2']), running: 0 });
    // Looked for and loaded, once for both.
    expect(asked.filter((address) => address === `${libs}/draco/gltf/draco_decoder.wasm`)).toHaveLength(2);
    expect(await draco.evaluate((element) => element.getAttribute('draco-path'))).toBe(`${libs}/draco/gltf`);

    await meshopt.evaluate(
      (element) =>
        new Promise((resolve) => {
          element.addEventListener('load', resolve);
          element.setAttribute('src', 'both.glb');
        }),
    );
    await expect.poll(async () => hues(await read(meshopt)).red).toBeGreaterThan(0.02);

    await draco.evaluate((element) => element.setAttribute('draco-path', 'nowhere'));
    await expect(alert).toHaveText(
      /^The model "draco\.glb" could not be read: it is packed with Draco, and its decoder was not found at http.*\/packed\/nowhere\/draco_.*\.$/,
    );
    await draco.evaluate(
      (element, dracoPath) => Object.assign(element, { dracoPath, src: 'damaged.glb' }),
      `${libs}/draco`,
    );
    await expect(alert).toHaveText(/^The model "damaged\.glb" could not be read: .* Not a Draco file\.$/);
    expect(pageProblems.splice(0).join()).toContain('Not a Draco file');
  });

  test('runs its decoders where a policy allows them, and says so where it forbids one', { tag: '@all' }, async ({
    page,
    pageProblems,
  }) => {
    const policy = "script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:";
    await openPacked(page, { 'Content-Security-Policy': policy });
    await elements(page).evaluateAll((all, path) => {
      all[0].setAttribute('draco-path', `${path}/draco/gltf/`);
      all[2].setAttribute('ktx2-path', `${path}/basis/`);
    }, libs);
    const [draco, , ktx2, meshopt] = await elements(page).all();
    await expect(ktx2.getByRole('alert')).toHaveText(
      "The model \"ktx2.glb\" could not be read: its pictures are packed as KTX2, and its decoder may not run: the page's Content-Security-Policy must allow worker-src blob: and script-src 'unsafe-eval'.",
    );
    for (const one of [draco, meshopt]) {
      await expect(one.locator('canvas[data-drawn]')).toHaveCount(1, { timeout: 60_000 });
    }
    expect(pageProblems.filter((problem) => !/Content[ -]Security[ -]Policy/i.test(problem))).toEqual([]);
    pageProblems.splice(0);
  });
});

interface Decoders {
  started: string[];
  running: number;
}
