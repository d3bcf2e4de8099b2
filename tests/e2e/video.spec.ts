import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { unzipSync } from 'three/addons/libs/fflate.module.js';
import { openPlayground, readDrawing, ready, savePicture } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';
import { loseContext, restoreContext } from './graphicsContext.js';
import { changedShare } from './pictures.js';

test.use({ viewport: { width: 560, height: 420 }, contextOptions: { reducedMotion: 'reduce' } });

const LOOK =
  'technique=hatching&model=cube&mapSize=64&mapTones=4&outlines=off&videoSize=page&videoSeconds=1&videoRate=12';

/** Records by the keyboard alone, and returns the file with its name. */
async function record(page: Page): Promise<{ name: string; content: Buffer }> {
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Record a video' }).press('Enter');
  const file = await download;
  return { name: file.suggestedFilename(), content: await readFile(await file.path()) };
}

/** Facts of a video as a browser plays it, with its first picture and those at some times as data URLs. @param rate frames a second */
async function play(page: Page, content: Buffer, rate: number, times: readonly number[]) {
  return page.evaluate(
    async ([base64, frameRate, seconds]) => {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      const video = document.createElement('video');
      video.muted = true;
      const when = (event: string) =>
        new Promise((resolve, reject) => {
          video.addEventListener(event, resolve, { once: true });
          video.addEventListener('error', () => reject(new Error(video.error?.message)), { once: true });
        });
      // Sought is sooner than shown: the time of the frame that is shown.
      let shown = -1;
      let onFrame = () => {};
      const follow: VideoFrameRequestCallback = (_, { mediaTime }) => {
        shown = mediaTime;
        onFrame();
        video.requestVideoFrameCallback(follow);
      };
      video.requestVideoFrameCallback(follow);
      const isLoaded = when('loadeddata');
      video.src = URL.createObjectURL(new Blob([bytes]));
      await isLoaded;
      const { videoWidth: width, videoHeight: height, duration } = video;
      const canvas = Object.assign(document.createElement('canvas'), { width, height });
      const pictures: string[] = [];
      const keep = () => {
        canvas.getContext('2d')!.drawImage(video, 0, 0);
        pictures.push(canvas.toDataURL());
      };
      keep();
      for (const time of seconds) {
        const isSought = when('seeked');
        video.currentTime = time;
        await isSought;
        // Times are rounded to milliseconds.
        while (shown > time || shown < time - 1 / frameRate - 0.001) await new Promise<void>((go) => (onFrame = go));
        keep();
      }
      return { width, height, duration, pictures };
    },
    [content.toString('base64'), rate, times] as const,
  );
}

const decoded = (address: string): PNG => PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));

async function openVideo(page: Page): Promise<void> {
  await openPlayground(page, LOOK);
  await page.getByRole('button', { name: 'Settings' }).click();
  await page.getByRole('button', { name: 'Video', exact: true }).click();
}

test('a turntable is recorded as a video that plays', async ({ page, context }) => {
  // The codec that every Chromium has, whatever others this one knows.
  await page.addInitScript(() => {
    const ask = VideoEncoder.isConfigSupported.bind(VideoEncoder);
    VideoEncoder.isConfigSupported = async (config) =>
      config.codec === 'vp8' ? ask(config) : { supported: false, config };
  });
  await openVideo(page);
  const size = await page.locator('#viewport').evaluate(({ clientWidth, clientHeight }) => ({
    width: 2 * Math.round(clientWidth / 2),
    height: 2 * Math.round(clientHeight / 2),
  }));

  const { name, content } = await record(page);
  expect(name).toBe('cube.webm');
  await expect(page.locator('#status')).toHaveText(
    `Saved: ${size.width} × ${size.height} px, 1 s with 12 frames a second, VP8 in WebM.`,
  );
  await expect(page.locator('.cover')).toHaveCount(0);

  const player = await context.newPage();
  await player.goto('/tests/browser/blank.html');
  const film = await play(player, content, 12, [0.26, 0.51, 0.97]);
  expect([film.width, film.height]).toEqual([size.width, size.height]);
  expect(film.duration).toBeCloseTo(1, 2);
  const [first, quarter, half, last] = film.pictures.map(decoded);
  await test.info().attach('first', { body: PNG.sync.write(first), contentType: 'image/png' });
  await test.info().attach('last', { body: PNG.sync.write(last), contentType: 'image/png' });
  expect(changedShare(first, quarter)).toBeGreaterThan(0.02);
  expect(changedShare(quarter, half)).toBeGreaterThan(0.02);
  // The last frame is one step before the first.
  expect(changedShare(first, last)).toBeGreaterThan(0);
  await player.close();
});

test('frames are saved as pictures without a video encoder; a lost film is offered again, and Cancel leaves the drawing as it was', {
  tag: '@all',
}, async ({ page }) => {
  await page.addInitScript(() => {
    VideoEncoder.isConfigSupported = async (config) => ({ supported: false, config });
  });
  await openVideo(page);
  const archive = await record(page);
  expect(archive.name).toBe('cube.zip');
  await expect(page.locator('#status')).toContainText('This browser encodes no video of that size.');
  const files = Object.entries(unzipSync(archive.content));
  expect(files.map(([path]) => path)).toEqual(
    Array.from({ length: 12 }, (_, i) => `cube-${String(i + 1).padStart(2, '0')}.png`),
  );
  const frames = files.map(([, file]) => PNG.sync.read(Buffer.from(file)));
  expect(new Set(frames.map(({ width, height }) => `${width} × ${height}`)).size).toBe(1);
  const steps = frames.map((frame, i) => changedShare(frame, frames[(i + 1) % frames.length]));
  test.info().annotations.push({ type: 'steps', description: steps.map((step) => step.toFixed(3)).join(' ') });
  expect(Math.min(...steps)).toBeGreaterThan(0.01);
  // Steps from frame to frame are equally large, including that from the last frame to the first.
  expect(Math.max(...steps)).toBeLessThan(3 * Math.min(...steps));

  // The first frame equals a saved picture of its size.
  await page.getByRole('combobox', { name: 'Motion' }).selectOption('The light goes around');
  const [start] = Object.values(unzipSync((await record(page)).content));
  const [frame, picture] = [PNG.sync.read(Buffer.from(start)), await savePicture(page)];
  expect([frame.width, frame.height]).toEqual([picture.width, picture.height]);
  expect(changedShare(frame, picture)).toBeLessThan(0.01);

  await page.getByRole('button', { name: 'Settings' }).click();
  const shown = await readDrawing(page);
  await page.getByRole('button', { name: 'Settings' }).click();
  // Errors can be read beside the open settings.
  await page.getByRole('combobox', { name: 'Motion' }).selectOption('The model’s own');
  await page.getByRole('button', { name: 'Record a video' }).press('Enter');
  const error = page.locator('#status');
  await expect(error).toContainText('No clip of this model is playing; choose another motion');
  expect((await error.boundingBox())!.width).toBeGreaterThan(200);
  await page.getByRole('combobox', { name: 'Motion' }).selectOption('The light swings');
  // Long enough to be cancelled on any machine.
  await page.getByRole('combobox', { name: 'Frames', exact: true }).selectOption('60 a second');
  const length = page.getByRole('spinbutton', { name: 'Length', exact: true }).last();
  await length.fill('30');
  await length.press('Enter');

  // The context is lost during the film, which is not blamed on the size; saving is offered again at once.
  const downloads: unknown[] = [];
  page.on('download', (one) => downloads.push(one));
  const again = page.getByRole('button', { name: 'Record it again' });
  await page.getByRole('button', { name: 'Record a video' }).press('Enter');
  await expect(page.locator('#status')).toHaveText('Recording the video…');
  await page.waitForFunction(
    () => document.querySelector<HTMLElement>('#progress-line')!.style.transform !== 'scaleX(0.04)',
  );
  await loseContext(page);
  await expect(page.locator('#status')).toHaveText(
    /let go of the drawing after \d+ of 1800 frames\. There is no video; record it again when the drawing is back/,
  );
  await expect(again).toBeVisible();
  await restoreContext(page);
  await expect(page.locator('html')).toHaveAttribute('data-state', 'ready');
  await test.info().attach('offered again', { body: await page.screenshot(), contentType: 'image/png' });
  await again.press('Enter');
  await expect(page.locator('#status')).toHaveText('Recording the video…');
  await expect(again).toBeHidden();
  await page.locator('#cancel').click();
  await expect(page.locator('#status')).toHaveText('Cancelled; the drawing is as it was.');

  await page.getByRole('button', { name: 'Record a video' }).press('Enter');
  await expect(page.locator('#status')).toHaveText('Recording the video…');
  await expect(page.locator('.cover')).toBeVisible();
  await page.locator('#cancel').click();
  await expect(page.locator('#status')).toHaveText('Cancelled; the drawing is as it was.');
  await expect(page.locator('.cover')).toHaveCount(0);
  await page.getByRole('button', { name: 'Settings' }).click();
  await ready(page);
  expect(changedShare(shown, await readDrawing(page))).toBe(0);
  expect(downloads).toEqual([]);
});
