import { chromium } from '@playwright/test';
import { launchOptions } from '../../browser/launchOptions.mjs';

/** The networks that a page is loaded over: as fast as this machine is, or a middling mobile one. Bits a second, and milliseconds. */
export const NETWORKS = {
  fast: undefined,
  mobile: { bits: 10e6, latency: 40 },
};

/** A model has more vertices than the ground that it stands on. */
const MODEL_VERTICES = 20_000;

/**
 * Opens the built playground in a browser of its own, where nothing is fetched or compiled yet, and measures, in milliseconds from the
 * navigation: when the graphics context was there, when the model was read, when its sketch was drawn, when its first frame in full
 * resolution was drawn, and when the last frame was drawn, with hollows and with lines along the form. Also the longest task of the main
 * thread.
 *
 * @param {string} address
 * @param {keyof typeof NETWORKS} network
 */
export async function timeColdPage(address, network) {
  const browser = await chromium.launch(await launchOptions());
  try {
    const page = await browser.newPage();
    page.on('pageerror', (error) => console.error(error));
    const limits = NETWORKS[network];
    if (limits) {
      const client = await page.context().newCDPSession(page);
      await client.send('Network.enable');
      const throughput = limits.bits / 8;
      await client.send('Network.emulateNetworkConditions', {
        offline: false,
        latency: limits.latency,
        downloadThroughput: throughput,
        uploadThroughput: throughput,
      });
    }
    await page.addInitScript(watch, MODEL_VERTICES);
    await page.goto(address, { waitUntil: 'commit' });
    await page.waitForFunction(
      () =>
        document.documentElement.dataset.state === 'ready' &&
        window.__playground.isIdle &&
        window.__times.drawing === 0 &&
        performance.now() - window.__times.complete > 1000,
      null,
      { timeout: 240_000, polling: 200 },
    );
    const { drawing, ...times } = await page.evaluate(() => window.__times);
    return times;
  } finally {
    await browser.close();
  }
}

/** Runs in the page, before its scripts. */
function watch(modelVertices) {
  const times = { drawing: 0, longestTask: 0 };
  window.__times = times;
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) times.longestTask = Math.max(times.longestTask, duration);
  }).observe({ entryTypes: ['longtask'] });

  const { Worker: PlainWorker } = window;
  window.Worker = class extends PlainWorker {
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        if (data?.kind === 'done') times.read ??= performance.now();
      });
    }
  };

  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (...args) {
    const gl = getContext.apply(this, args);
    if (this.id === 'drawing' && gl && times.context === undefined) {
      times.context = performance.now();
      watchFrames(gl);
    }
    return gl;
  };

  function watchFrames(gl) {
    let hasModel = false;
    for (const [name, place] of [
      ['drawArrays', 2],
      ['drawElements', 1],
    ]) {
      const draw = gl[name];
      gl[name] = (...args) => {
        hasModel ||= args[place] > modelVertices;
        draw.apply(gl, args);
      };
    }
    const request = window.requestAnimationFrame;
    window.requestAnimationFrame = (callback) =>
      request.call(window, (time) => {
        hasModel = false;
        callback(time);
        if (hasModel) noteDrawn(gl);
      });
  }

  /** Notes when the graphics card has drawn all that it was asked for. */
  function noteDrawn(gl) {
    const isWhole = gl.drawingBufferWidth >= document.querySelector('#viewport').clientWidth;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    times.drawing++;
    const poll = () => {
      if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
        setTimeout(poll, 5);
        return;
      }
      gl.deleteSync(fence);
      times.drawing--;
      times.complete = performance.now();
      times.sketch ??= times.complete;
      if (isWhole) times.whole ??= times.complete;
    };
    setTimeout(poll, 5);
  }
}
