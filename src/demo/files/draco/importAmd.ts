/** By their addresses: a script hands out what it holds when it runs, which it does but once. */
const imported = new Map<string, Promise<unknown>>();

/** One at a time, since a script does not say which it is. */
let last: Promise<unknown> = Promise.resolve();

/**
 * What a script holds that hands it to a loader of AMD modules, if there is one. It is imported as a module: the only way that
 * pages and workers of modules share, and that no Content-Security-Policy forbids which allows the page's own scripts.
 *
 * @throws Error if it cannot be fetched, or holds nothing
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
