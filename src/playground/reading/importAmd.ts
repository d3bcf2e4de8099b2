/** The exports of scripts by address; a script runs, and delivers them, only once. */
const imported = new Map<string, Promise<unknown>>();

/** Scripts are imported one at a time, since a script does not identify itself. */
let last: Promise<unknown> = Promise.resolve();

/**
 * Imports a script with AMD exports. It is imported as a module, which works in pages and module workers alike, and under any
 * Content-Security-Policy that allows the page's own scripts.
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
