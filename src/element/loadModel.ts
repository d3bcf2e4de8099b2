import type { Material, Mesh, Object3D, SkinnedMesh, Texture } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** What the loader says of files that it needs a further decoder for, and what they are packed with. */
const PACKED: readonly [message: RegExp, what: string][] = [
  [
    /DRACOLoader/,
    'It is packed with Draco, which <hatched-model> does not read. Save it without, or packed with Meshopt.',
  ],
  [
    /KTX2Loader/,
    'Its pictures are packed as KTX2, which <hatched-model> does not read. Save them as PNG, JPEG or WebP.',
  ],
];

/**
 * Loads a glTF or GLB file.
 *
 * @throws Error with a sentence for the reader of the page
 */
export async function loadModel(address: string): Promise<Object3D> {
  try {
    return await read(address, new GLTFLoader());
  } catch (cause) {
    throw new Error(sentenceOf(address, cause), { cause });
  }
}

/** Fetches the decoder of Meshopt where a file needs it: it is WebAssembly, which strict policies forbid, used or not. */
async function read(address: string, loader: GLTFLoader): Promise<Object3D> {
  try {
    return (await loader.loadAsync(address)).scene;
  } catch (error) {
    if (!/setMeshoptDecoder/.test(String(error))) throw error;
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
    return (await loader.setMeshoptDecoder(MeshoptDecoder).loadAsync(address)).scene;
  }
}

/** Frees what a loaded model holds on the graphics card. */
export function disposeModel(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material, skeleton } = object as Partial<SkinnedMesh> & Partial<Mesh>;
    geometry?.dispose();
    skeleton?.dispose();
    for (const one of [material ?? []].flat()) disposeMaterial(one);
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
  const message = cause instanceof Error ? cause.message : String(cause);
  const name = address.startsWith('data:') ? 'of the page' : `"${address.split(/[?#]/)[0].split('/').at(-1)}"`;
  const status = /responded with (\d+)/.exec(message)?.[1];
  if (status) return `The model ${name} could not be fetched: the server answered ${status}.`;
  if (/failed to fetch|networkerror|load failed/i.test(message)) {
    return `The model ${name} could not be fetched: the server does not answer, or forbids it.`;
  }
  const packed = PACKED.find(([pattern]) => pattern.test(message))?.[1];
  return packed ? `The model ${name} could not be read. ${packed}` : `The model ${name} could not be read: ${message}`;
}
