import { LoadingManager } from 'three';
import dracoWasmUrl from 'three/addons/libs/draco/gltf/draco_decoder.wasm?url';
import dracoScriptUrl from 'three/addons/libs/draco/gltf/draco_wasm_wrapper.js?url';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { checkBufferViews, type GltfDocument, readGltfDocument, splitGlb, withoutPictures } from './gltfFile.js';
import { ModelError } from './ModelError.js';
import { mergeScene } from './mergeScene.js';
import type { PlainMesh } from './PlainMesh.js';

/** Bytes of a file of the drop by the name another file uses for it, or undefined. */
export type FindFile = (uri: string) => Promise<Uint8Array | undefined>;

/** Reads GLB, or glTF with its files, also when compressed with Draco or meshopt. Nothing is fetched from elsewhere. */
export async function readGltf(
  bytes: Uint8Array,
  name: string,
  isBinary: boolean,
  findFile: FindFile,
): Promise<PlainMesh> {
  const { text, binary } = isBinary
    ? splitGlb(bytes, name)
    : { text: new TextDecoder().decode(bytes), binary: undefined };
  const gltf = readGltfDocument(text, name);
  const buffers = await collectBuffers(gltf, name, binary, findFile);
  checkBufferViews(
    gltf,
    buffers.map((buffer) => buffer.length),
    name,
  );

  const urls = buffers.map((buffer) => URL.createObjectURL(new Blob([buffer as Uint8Array<ArrayBuffer>])));
  const manager = new LoadingManager();
  manager.setURLModifier((url) => {
    if (/^(blob|data):/.test(url) || url === dracoUrls.js || url === dracoUrls.wasm) return url;
    throw new ModelError(`${name} refers to ${url}, which is not among the dropped files.`);
  });
  const loader = new GLTFLoader(manager);
  const draco = new DRACOLoader(manager).setDecoderPath(dracoUrls as never);
  loader.setDRACOLoader(draco);
  try {
    if (/meshopt_compression/.test(text)) {
      const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
      loader.setMeshoptDecoder(MeshoptDecoder);
    }
    const placed = {
      ...withoutPictures(gltf),
      buffers: buffers.map((buffer, i) => ({ byteLength: buffer.length, uri: urls[i] })),
    };
    const { scene } = await loader.parseAsync(placed as never, '');
    return mergeScene(scene);
  } finally {
    draco.dispose();
    for (const url of urls) URL.revokeObjectURL(url);
  }
}

const dracoUrls = {
  js: new URL(dracoScriptUrl, import.meta.url).href,
  wasm: new URL(dracoWasmUrl, import.meta.url).href,
};

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
        // A compressed buffer's fallback has no bytes of its own.
        if (extensions) return new Uint8Array(0);
        throw new ModelError(`${name} is cut short: its binary part is missing.`);
      }
      const found = uri.startsWith('data:')
        ? new Uint8Array(await (await fetch(uri)).arrayBuffer())
        : await findFile(uri);
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

function baseName(uri: string): string {
  return uri.split(/[\\/]/).pop() ?? uri;
}
