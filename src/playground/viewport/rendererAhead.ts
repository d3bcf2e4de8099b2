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
