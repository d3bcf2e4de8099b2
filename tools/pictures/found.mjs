import { mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join, parse } from 'node:path';
import { PNG } from 'pngjs';
import { isSettled } from './isSettled.mjs';

const MODEL = /\.(glb|gltf|obj|stl|ply|off|3mf|fbx|dae|3ds|wrl|usdz)$/i;
const SIDE = 700;
/** The time limit of a file, milliseconds. */
const PATIENCE = 180_000;

/**
 * Drops found scenes on the page, one by one, and writes what it shows into tests/output/found: those of foundScenes.ts, and the models
 * of a folder. A folder within it is one model with its companions, as are files of one name.
 *
 * @param {import('vite').ViteDevServer} server
 * @param {import('@playwright/test').Browser} browser
 * @param {string} root of the project
 * @param {string | undefined} folder of models
 */
export async function drawFound(server, browser, root, folder) {
  const output = join(root, 'tests/output/found');
  mkdirSync(output, { recursive: true });
  const address = server.resolvedUrls.local[0];
  const writer = await browser.newPage();
  await writer.goto(`${address}tools/pictures/found.html`);
  await writer.waitForFunction(() => window.writeFound !== undefined);
  const written = (await writer.evaluate(() => window.writeFound())).map(({ name, content }) => [
    { name, mimeType: 'application/octet-stream', buffer: Buffer.from(content, 'base64') },
  ]);
  await writer.close();
  const page = await browser.newPage({ viewport: { width: SIDE, height: SIDE }, reducedMotion: 'reduce' });
  await page.goto(address);
  await page.waitForFunction(isSettled, null, { polling: 100, timeout: PATIENCE });
  await page.evaluate(() => {
    Object.assign(document.getElementById('viewport').style, { position: 'fixed', inset: '0', zIndex: '9' });
    for (const over of document.querySelectorAll('.lamp, .turn-hint')) over.style.display = 'none';
  });
  for (const files of [...written, ...(folder ? modelsOf(folder) : [])]) {
    const [{ name }] = files;
    try {
      await page.setInputFiles('#file-input', files);
      await page.waitForFunction((title) => document.getElementById('model-name')?.textContent === title, name, {
        timeout: PATIENCE,
      });
      await page.waitForFunction(isSettled, null, { polling: 100, timeout: PATIENCE });
    } catch (error) {
      console.error(`found: ${name} was not drawn: ${error.message.split('\n')[0]}`);
      continue;
    }
    const picture = await page.screenshot({ path: join(output, `${parse(name).name}.png`) });
    console.log(`found: ${name}, ${inkOf(PNG.sync.read(picture))}`);
  }
  await page.close();
}

/** The model files of a folder, each first among its companions, with their contents. */
function modelsOf(folder) {
  return readdirSync(folder, { withFileTypes: true })
    .map((entry) => {
      if (!entry.isDirectory()) {
        if (!MODEL.test(entry.name)) return [];
        const { name } = parse(entry.name);
        const others = readdirSync(folder).filter(
          (one) => one !== entry.name && parse(one).name === name && !MODEL.test(one),
        );
        return [entry.name, ...others].map((one) => join(folder, one));
      }
      const within = readdirSync(join(folder, entry.name)).map((one) => join(folder, entry.name, one));
      const model = within.find((one) => MODEL.test(one));
      return model ? [model, ...within.filter((one) => one !== model)] : [];
    })
    .filter((paths) => paths.length > 0)
    .map((paths) =>
      paths.map((path) => ({
        name: basename(path),
        mimeType: 'application/octet-stream',
        buffer: readFileSync(path),
      })),
    );
}

/** The shares of the picture that are dark and very dark, in words. */
function inkOf({ data }) {
  const counts = [0, 0];
  for (let i = 0; i < data.length; i += 4) {
    if (data[i] < 128) counts[0]++;
    if (data[i] < 64) counts[1]++;
  }
  const [dark, black] = counts.map((count) => ((400 * count) / data.length).toFixed(1));
  return `${dark} % dark, ${black} % black`;
}
