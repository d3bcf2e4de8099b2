import type { DecoderModule } from 'draco3d';
import scriptUrl from 'three/addons/libs/draco/gltf/draco_decoder.js?url';
import wasmUrl from 'three/addons/libs/draco/gltf/draco_decoder.wasm?url';
import wasmScriptUrl from 'three/addons/libs/draco/gltf/draco_wasm_wrapper.js?url';
import { importAmd } from './importAmd.js';

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
