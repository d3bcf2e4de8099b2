import { type BufferGeometry, LinearSRGBColorSpace } from 'three';
import dracoWasmUrl from 'three/addons/libs/draco/gltf/draco_decoder.wasm?url';
import dracoScriptUrl from 'three/addons/libs/draco/gltf/draco_wasm_wrapper.js?url';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { ModelError } from './ModelError.js';

/** Draco's ids of the attributes of a part, and the names of the typed arrays for their values. */
export type DracoAttributes = Record<string, { id: number; arrayType: string }>;

/** The types lack these methods. */
interface AllMethods {
  _loadLibrary(url: string, responseType: string): Promise<string | ArrayBuffer>;
  decodeDracoFile(
    buffer: ArrayBufferLike,
    onLoad: (geometry: BufferGeometry) => void,
    ids: Record<string, number>,
    types: Record<string, string>,
    colorSpace: string,
    onError: (error: unknown) => void,
  ): void;
}

const urls = {
  js: new URL(dracoScriptUrl, import.meta.url).href,
  wasm: new URL(dracoWasmUrl, import.meta.url).href,
};

const forbidden = ({ effectiveDirective }: SecurityPolicyViolationEvent): ModelError =>
  new ModelError(
    `The model is packed with Draco, which this page may not unpack: its Content-Security-Policy forbids it (${effectiveDirective}).`,
  );

/** Its workers write every damaged part on the console. Who dropped the file gets a sentence instead. */
class QuietDracoLoader extends (DRACOLoader as unknown as new () => DRACOLoader & AllMethods) {
  override async _loadLibrary(url: string, responseType: string): Promise<string | ArrayBuffer> {
    const library = await super._loadLibrary(url, responseType);
    return typeof library === 'string' ? `console.error = () => {};\n${library}` : library;
  }
}

/** Unpacks what is packed with Draco, in workers of its own. */
export class DracoUnpacker {
  private readonly loader = new QuietDracoLoader();

  constructor() {
    this.loader.setDecoderPath(urls as never);
  }

  unpack(bytes: Uint8Array, attributes: DracoAttributes): Promise<BufferGeometry> {
    const ids: Record<string, number> = {};
    const types: Record<string, string> = {};
    for (const [name, { id, arrayType }] of Object.entries(attributes)) {
      ids[name] = id;
      types[name] = arrayType;
    }
    const done = new AbortController();
    return new Promise<BufferGeometry>((resolve, reject) => {
      // The loader waits for ever for a worker that it may not make.
      globalThis.addEventListener('securitypolicyviolation', (event) => reject(forbidden(event)), {
        signal: done.signal,
      });
      this.loader.decodeDracoFile(bytes.slice().buffer, resolve, ids, types, LinearSRGBColorSpace, reject);
    }).finally(() => done.abort());
  }

  dispose(): void {
    this.loader.dispose();
  }
}
