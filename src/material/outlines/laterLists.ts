type Lists = typeof import('./contourLists.js');

let fetched: Lists | undefined;
let isAsked = false;

/** The code of the lists of primitives; undefined until it has been fetched, which the first call begins. */
export function fetchedLists(): Lists | undefined {
  if (!isAsked) {
    isAsked = true;
    // Without it, all primitives are tested.
    fetch().catch(() => {});
  }
  return fetched;
}

async function fetch(): Promise<void> {
  fetched = await import('./contourLists.js');
}
