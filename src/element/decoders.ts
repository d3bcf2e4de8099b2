import type { WebGLRenderer } from 'three';
import type { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';
import type { GltfExtensions } from './readExtensions.js';

/** The URL of a model, and the settings to decode it. */
export interface ModelSource {
  address: string;
  /** The folders of the decoders; undefined without the attribute. */
  folders: Readonly<Record<'draco' | 'ktx2', string | undefined>>;
  /** The material variant: a name, or a number from 1 on; '' for none. */
  variant: string;
  /** The renderer that will draw the model. */
  renderer: WebGLRenderer;
}

const PACKED = { draco: 'it is packed with Draco', ktx2: 'its pictures are packed as KTX2' } as const;

/**
 * Gives a loader the decoders that a file needs.
 *
 * @returns a function to call when the file has been read
 * @throws Error whose message continues a sentence about the model, if a decoder is missing or fails
 */
export async function addDecoders(
  loader: GLTFLoader,
  { used, required }: GltfExtensions,
  { folders, renderer }: ModelSource,
): Promise<() => void> {
  const borrowed: (() => void)[] = [];
  const giveBack = (): void => {
    for (const release of borrowed) release();
  };
  const borrow = async <Kind extends keyof Decoders>(kind: Kind): Promise<Decoders[Kind]> => {
    const folder = folders[kind];
    if (!folder)
      throw new Error(`${PACKED[kind]}, and the attribute ${kind}-path must name the folder of its decoder.`);
    borrowed.push(() => returnDecoder(kind, folder));
    try {
      return await borrowDecoder(kind, folder, renderer);
    } catch (error) {
      throw new Error(`${PACKED[kind]}, and its decoder ${(error as Error).message}`);
    }
  };
  try {
    if (required.some((name) => name.endsWith('_meshopt_compression'))) {
      loader.setMeshoptDecoder((await import('three/addons/libs/meshopt_decoder.module.js')).MeshoptDecoder);
    }
    if (used.includes('KHR_draco_mesh_compression')) loader.setDRACOLoader(await borrow('draco'));
    // If the extension is not required, the file has other textures as a fallback.
    if (required.includes('KHR_texture_basisu') || (folders.ktx2 && used.includes('KHR_texture_basisu'))) {
      loader.setKTX2Loader(await borrow('ktx2'));
    }
    return giveBack;
  } catch (error) {
    giveBack();
    throw error;
  }
}

/** A shared resource and the number of its users. */
interface Shared<Resource> {
  resource: Promise<Resource>;
  users: number;
}

/** Resources that are made once for all concurrent users, and freed when the last user gives them back. */
export class SharedResources<Key, Resource extends { dispose(): void }> {
  private readonly shared = new Map<Key, Shared<Resource>>();

  /**
   * Returns the resource of a key. It must be given back, even if making it failed.
   *
   * @param make makes the resource; called if it has no users
   */
  borrow(key: Key, make: () => Promise<Resource>): Promise<Resource> {
    let entry = this.shared.get(key);
    if (!entry) {
      entry = { resource: make(), users: 0 };
      this.shared.set(key, entry);
    }
    entry.users++;
    return entry.resource;
  }

  /** Gives back the resource of a key, which is freed with its last user. */
  giveBack(key: Key): void {
    const entry = this.shared.get(key);
    if (!entry || --entry.users > 0) return;
    this.shared.delete(key);
    entry.resource.then(
      (resource) => resource.dispose(),
      () => {
        // The error was reported to the borrowers.
      },
    );
  }
}

/** The decoders of three.js whose files are in a folder of the page. */
export interface Decoders {
  draco: DRACOLoader;
  ktx2: KTX2Loader;
}

interface Recipe<Decoder> {
  files: readonly string[];
  /** Resolves when all files are loaded: a decoder that is disposed of earlier would start workers afterwards. */
  make(folder: string, renderer: WebGLRenderer): Promise<Decoder>;
  /** Code that does everything the decoder's worker must be allowed to do. */
  probe: string;
  /** The source expression in a Content-Security-Policy that allows it. */
  policy: string;
}

/** Code that compiles the smallest WebAssembly module. */
const COMPILE = 'new WebAssembly.Module(new Uint8Array([0,97,115,109,1,0,0,0]));';

const RECIPES: { [Kind in keyof Decoders]: Recipe<Decoders[Kind]> } = {
  draco: {
    files: ['draco_wasm_wrapper.js', 'draco_decoder.wasm'],
    async make(folder) {
      const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js');
      const decoder = new DRACOLoader().setDecoderPath(folder).preload();
      await (decoder as { decoderPending?: Promise<unknown> }).decoderPending;
      return decoder;
    },
    probe: COMPILE,
    policy: "'wasm-unsafe-eval'",
  },
  ktx2: {
    files: ['basis_transcoder.js', 'basis_transcoder.wasm'],
    async make(folder, renderer) {
      const { KTX2Loader } = await import('three/addons/loaders/KTX2Loader.js');
      const decoder = new KTX2Loader().setTranscoderPath(folder).detectSupport(renderer);
      await decoder.init();
      return decoder;
    },
    // Its script creates functions from strings.
    probe: `${COMPILE}new Function('');`,
    policy: "'unsafe-eval'",
  },
};

/** Keyed by kind and folder. */
const shared = new SharedResources<string, DRACOLoader | KTX2Loader>();

/**
 * Returns a decoder, which all models that are being loaded with it share. Give it back with {@link returnDecoder}, even if it fails.
 *
 * @param folder the URL of its folder, with a slash at its end
 * @param renderer the renderer that draws the textures: they are transcoded to a format of its GPU
 * @throws Error whose message continues a sentence that begins with the decoder
 */
function borrowDecoder<Kind extends keyof Decoders>(
  kind: Kind,
  folder: string,
  renderer: WebGLRenderer,
): Promise<Decoders[Kind]> {
  const make = (): Promise<Decoders[Kind]> => start(RECIPES[kind], folder, renderer);
  return shared.borrow(`${kind} ${folder}`, make) as Promise<Decoders[Kind]>;
}

/** Gives back a decoder, whose workers end with its last user. */
const returnDecoder = (kind: keyof Decoders, folder: string): void => shared.giveBack(`${kind} ${folder}`);

/** Makes a decoder, after checking that it can work on this page: one that cannot would never answer. */
async function start<Decoder>(
  { files, make, probe, policy }: Recipe<Decoder>,
  folder: string,
  renderer: WebGLRenderer,
): Promise<Decoder> {
  await Promise.all([...files.map((file) => findFile(folder + file)), tryWorker(probe, policy)]);
  return make(folder, renderer);
}

async function findFile(address: string): Promise<void> {
  const enough = new AbortController();
  const response = await fetch(address, { signal: enough.signal }).catch(() => undefined);
  // Many servers answer with an HTML page if a file is missing.
  const isThere = response?.ok && !response.headers.get('Content-Type')?.includes('html');
  enough.abort();
  if (!isThere) throw new Error(`was not found at ${address}.`);
}

/** Checks that a worker from a blob starts, and may do what the decoder does. */
async function tryWorker(probe: string, policy: string): Promise<void> {
  const address = URL.createObjectURL(new Blob([`${probe}postMessage(0)`], { type: 'text/javascript' }));
  let worker: Worker | undefined;
  try {
    await new Promise<unknown>((resolve, reject) => {
      worker = new Worker(address);
      worker.onmessage = resolve;
      worker.onerror = reject;
    });
  } catch {
    throw new Error(
      `may not run: the page's Content-Security-Policy must allow worker-src blob: and script-src ${policy}.`,
    );
  } finally {
    worker?.terminate();
    URL.revokeObjectURL(address);
  }
}
