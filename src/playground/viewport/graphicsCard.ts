declare global {
  /** The name of the WebGL 2 renderer, which a script ahead of the page's own asks for in a worker: see tools/building/fetchedAhead.ts. */
  var hatchingRenderer: Promise<string | undefined> | undefined;
  /** Whether the page's own script runs. The script ahead does nothing if it comes later. */
  var hatchingHasBegun: boolean | undefined;
}

/**
 * The name of the graphics card and its driver, once the browser has set up its graphics, after which a context is created at once.
 * Undefined if unknown, or if it takes too long.
 */
export async function rendererAhead(): Promise<string | undefined> {
  globalThis.hatchingHasBegun = true;
  return globalThis.hatchingRenderer;
}

/** The name of a context's graphics card and driver, as far as the browser tells it. */
export function rendererName(gl: WebGL2RenderingContext): string {
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  return String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
}

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/**
 * Whether the browser draws WebGL 2 in software, without a graphics card or a driver for it.
 *
 * @param renderer its name, if known; otherwise a context is created to find out
 */
export function drawsInSoftware(renderer?: string): boolean {
  if (renderer !== undefined) return SOFTWARE.test(renderer);
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (!gl) return false;
  const name = rendererName(gl);
  // Browsers allow a page few contexts.
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE.test(name);
}

const POLL_MILLISECONDS = 10;

/**
 * Resolves when the graphics card has finished all commands so far, or the context was lost. Reading pixels earlier would block the page
 * until then.
 */
export function whenDrawn(gl: WebGL2RenderingContext): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  // Without the flush, the fence might wait for the commands of the next frame.
  gl.flush();
  return new Promise((resolve) => {
    const poll = (): void => {
      // A fence is invalid once its context was lost, even if the context has been restored since.
      if (fence && gl.isSync(fence) && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
        setTimeout(poll, POLL_MILLISECONDS);
        return;
      }
      gl.deleteSync(fence);
      resolve();
    };
    setTimeout(poll, POLL_MILLISECONDS);
  });
}

/** The maximum wait for a frame to be submitted, in milliseconds: a hidden page draws none. */
const FRAME_MILLISECONDS = 100;
/** The maximum wait for a frame to be drawn, in milliseconds. */
const DRAWING_MILLISECONDS = 1000;

/** Resolves when the next frame is on the page. */
export async function afterFrame(context: WebGL2RenderingContext): Promise<void> {
  await within(FRAME_MILLISECONDS, new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  await within(DRAWING_MILLISECONDS, whenDrawn(context));
}

/** Resolves with a task, or after a timeout in milliseconds. */
async function within(milliseconds: number, task: Promise<unknown>): Promise<void> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  await Promise.race([task, new Promise((resolve) => (timer = setTimeout(resolve, milliseconds)))]);
  clearTimeout(timer);
}
