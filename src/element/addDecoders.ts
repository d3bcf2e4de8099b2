import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { borrowDecoder, type Decoders, returnDecoder } from './decoders.js';
import type { ModelSource } from './ModelSource.js';
import type { GltfExtensions } from './readExtensions.js';

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
