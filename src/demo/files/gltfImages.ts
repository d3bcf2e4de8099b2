import type { FindFile } from './FindFile.js';
import { type GltfDocument, textureSource } from './gltfFile.js';
import { imageSize } from './imageSize.js';
import { readUri } from './readUri.js';

/** An image file of 44 kilobytes can decode to a gigabyte. */
const MAX_PIXELS = 2 ** 26;

/**
 * Collects the images that base colour textures use, by their index in the document. An image is undefined if it is not
 * used, missing, too large to be decoded, or in an unknown format.
 */
export async function collectImages(
  gltf: GltfDocument,
  buffers: readonly Uint8Array[],
  findFile: FindFile,
): Promise<(Blob | undefined)[]> {
  const used = new Set(
    (gltf.materials ?? []).map((material) =>
      textureSource(gltf, material.pbrMetallicRoughness?.baseColorTexture?.index),
    ),
  );
  return Promise.all(
    (gltf.images ?? []).map(async ({ uri, bufferView }, i) => {
      if (!used.has(i)) return undefined;
      const bytes = uri === undefined ? viewBytes(gltf, buffers, bufferView) : await readUri(uri, findFile);
      const size = bytes && imageSize(bytes);
      if (!size || size[0] * size[1] > MAX_PIXELS || size[0] * size[1] === 0) return undefined;
      return new Blob([bytes as Uint8Array<ArrayBuffer>]);
    }),
  );
}

function viewBytes(
  gltf: GltfDocument,
  buffers: readonly Uint8Array[],
  index: number | undefined,
): Uint8Array | undefined {
  const view = gltf.bufferViews?.[index ?? -1];
  const offset = view?.byteOffset ?? 0;
  return view && buffers[view.buffer ?? -1]?.subarray(offset, offset + (view.byteLength ?? 0));
}
