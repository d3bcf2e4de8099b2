import {
  FileLoader,
  LoaderUtils,
  type Material,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
  type Texture,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { ModelSource } from './ModelSource.js';
import { readExtensions } from './readExtensions.js';

/** The extensions that need decoders. Decoders are loaded only when needed: they are large, and strict policies forbid WebAssembly. */
const PACKED = /^(KHR_draco_mesh_compression|(EXT|KHR)_meshopt_compression|KHR_texture_basisu)$/;

/**
 * Loads a glTF or GLB file.
 *
 * @throws Error whose message is a sentence for the reader of the page
 */
export async function loadModel(source: ModelSource): Promise<Object3D> {
  const { address } = source;
  let giveBack: (() => void) | undefined;
  try {
    const content = (await new FileLoader().setResponseType('arraybuffer').loadAsync(address)) as ArrayBuffer;
    const loader = new GLTFLoader();
    const extensions = readExtensions(content);
    if (extensions.used.some((name) => PACKED.test(name))) {
      giveBack = await (await import('./addDecoders.js')).addDecoders(loader, extensions, source);
    }
    return (await loader.parseAsync(content, LoaderUtils.extractUrlBase(address))).scene;
  } catch (cause) {
    throw new Error(sentenceOf(address, cause), { cause });
  } finally {
    giveBack?.();
  }
}

/** Frees the GPU memory of a loaded model. */
export function disposeModel(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material, skeleton } = object as Partial<SkinnedMesh> & Partial<Mesh>;
    geometry?.dispose();
    skeleton?.dispose();
    for (const entry of [material ?? []].flat()) disposeMaterial(entry);
  });
}

function disposeMaterial(material: Material): void {
  for (const value of Object.values(material)) {
    if (!isTexture(value)) continue;
    value.dispose();
    const { data } = value.source;
    if (typeof ImageBitmap !== 'undefined' && data instanceof ImageBitmap) data.close();
  }
  material.dispose();
}

const isTexture = (value: unknown): value is Texture =>
  typeof value === 'object' && value !== null && 'isTexture' in value;

function sentenceOf(address: string, cause: unknown): string {
  const message = messageOf(cause);
  const name = address.startsWith('data:') ? 'of the page' : `"${address.split(/[?#]/)[0].split('/').at(-1)}"`;
  const status = /responded with (\d+)/.exec(message)?.[1];
  if (status) return `The model ${name} could not be fetched: the server answered ${status}.`;
  if (/failed to fetch|networkerror|load failed/i.test(message)) {
    return `The model ${name} could not be fetched: the server does not answer, or forbids it.`;
  }
  return `The model ${name} could not be read: ${message}`;
}

/** The message of an error. The workers of Draco throw plain objects. */
const messageOf = (cause: unknown): string =>
  cause instanceof Error ? cause.message : String((cause as { error?: unknown } | undefined)?.error ?? cause);
