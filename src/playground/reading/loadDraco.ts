import type { DecoderModule } from 'draco3d';
import scriptUrl from 'three/addons/libs/draco/gltf/draco_decoder.js?url';
import wasmUrl from 'three/addons/libs/draco/gltf/draco_decoder.wasm?url';
import wasmScriptUrl from 'three/addons/libs/draco/gltf/draco_wasm_wrapper.js?url';

type StartDraco = (options: object) => Promise<DecoderModule>;

/** Silences the decoder's console output about damaged parts, which are reported in a sentence instead. */
const QUIET = { print: () => {}, printErr: () => {} };

/**
 * Loads Draco's decoder, which runs on the calling thread: in WebAssembly or, where a page may not use that, in JavaScript, which takes
 * three times as long.
 *
 * @throws Error if it cannot be fetched
 */
export async function loadDraco(): Promise<DecoderModule> {
  try {
    const wasmBinary = await fetchBytes(wasmUrl);
    return await start(wasmScriptUrl, { ...QUIET, wasmBinary });
  } catch {
    return start(scriptUrl, QUIET);
  }
}

const start = async (url: string, options: object): Promise<DecoderModule> =>
  (await importAmd<StartDraco>(url))(options);

async function fetchBytes(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  return response.arrayBuffer();
}

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
