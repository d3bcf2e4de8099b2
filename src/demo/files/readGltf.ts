import type { FindFile } from './FindFile.js';
import { baseName } from './fileName.js';
import { checkBufferViews, type GltfDocument, isDrawnAsScene, readGltfDocument, splitGlb } from './gltfFile.js';
import { collectImages } from './gltfImages.js';
import { ModelError } from './ModelError.js';
import { mergeScene } from './mergeScene.js';
import type { PlainMesh } from './PlainMesh.js';
import { type GltfParts, parseGltf } from './parseGltf.js';
import { readUri } from './readUri.js';

/**
 * Reads GLB, or glTF with its files, also if compressed with Draco or meshopt. Nothing else is fetched.
 *
 * @returns one merged mesh; or, if that could not show what is in the file, its checked parts
 */
export async function readGltf(
  bytes: Uint8Array,
  name: string,
  isBinary: boolean,
  findFile: FindFile,
): Promise<PlainMesh | GltfParts> {
  const { text, binary } = isBinary
    ? splitGlb(bytes, name)
    : { text: new TextDecoder().decode(bytes), binary: undefined };
  const document = readGltfDocument(text, name);
  const buffers = await collectBuffers(document, name, binary, findFile);
  checkBufferViews(
    document,
    buffers.map((buffer) => buffer.length),
    name,
  );
  if (isDrawnAsScene(document)) {
    return { name, document, buffers, images: await collectImages(document, buffers, findFile) };
  }
  const { animations: _, ...still } = document;
  const { root } = await parseGltf({ name, document: still, buffers, images: [] });
  return mergeScene(root);
}

async function collectBuffers(
  gltf: GltfDocument,
  name: string,
  binary: Uint8Array | undefined,
  findFile: FindFile,
): Promise<Uint8Array[]> {
  return Promise.all(
    (gltf.buffers ?? []).map(async ({ uri, byteLength = 0, extensions }, i) => {
      if (uri === undefined) {
        if (i === 0 && binary) return binary;
        // The fallback of a compressed buffer has no bytes of its own.
        if (extensions) return new Uint8Array(0);
        throw new ModelError(`${name} is cut short: its binary part is missing.`);
      }
      const found = await readUri(uri, findFile);
      if (!found) throw new ModelError(`${name} needs ${baseName(uri)}; drop both files together.`);
      if (found.length < byteLength) {
        throw new ModelError(
          `${uri.startsWith('data:') ? name : baseName(uri)} is cut short: ${name} expects more data in it.`,
        );
      }
      return found;
    }),
  );
}
