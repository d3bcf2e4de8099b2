/** The exports of scripts, by their addresses: a script hands them out when it runs, and it runs only once. */
const imported = new Map<string, Promise<unknown>>();

/** Scripts are imported one at a time, since a script does not say which one it is. */
let last: Promise<unknown> = Promise.resolve();

/**
 * The exports of a script that offers them to a loader of AMD modules. It is imported as a module: that works in pages and in module
 * workers alike, and wherever a Content-Security-Policy allows the page's own scripts.
 *
 * @throws Error if it cannot be fetched, or exports nothing
 */
export function importAmd<Held>(address: string): Promise<Held> {
  let held = imported.get(address);
  if (!held) {
    held = last.then(() => receive(address));
    imported.set(address, held);
    last = held.catch(() => imported.delete(address));
  }
  return held as Promise<Held>;
}

async function receive(address: string): Promise<unknown> {
  const former = Object.getOwnPropertyDescriptor(globalThis, 'define');
  let held: unknown;
  const define = Object.assign(
    (_needed: unknown, make: () => unknown) => {
      held = make();
    },
    { amd: true },
  );
  Object.defineProperty(globalThis, 'define', { value: define, configurable: true });
  try {
    await import(/* @vite-ignore */ address);
  } finally {
    if (former) Object.defineProperty(globalThis, 'define', former);
    else Reflect.deleteProperty(globalThis, 'define');
  }
  if (held === undefined) throw new Error(`${address} holds nothing`);
  return held;
}
