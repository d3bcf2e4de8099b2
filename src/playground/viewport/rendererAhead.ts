declare global {
  /** Who draws WebGL 2, as the script ahead of the page's own has found out in a worker: see tools/building/fetchedAhead.ts. */
  var hatchingRenderer: Promise<string | undefined> | undefined;
  /** Whether the page's own script runs. A script ahead that comes later than that does nothing. */
  var hatchingHasBegun: boolean | undefined;
}

/**
 * The name of the graphics card and its driver, once the browser has set up its graphics: a context is there at once then. Undefined where
 * nobody has found out, or where it takes too long.
 */
export async function rendererAhead(): Promise<string | undefined> {
  globalThis.hatchingHasBegun = true;
  return globalThis.hatchingRenderer;
}
