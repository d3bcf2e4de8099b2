import { type AnimationClip, type Group, LoadingManager } from 'three';
import dracoWasmUrl from 'three/addons/libs/draco/gltf/draco_decoder.wasm?url';
import dracoScriptUrl from 'three/addons/libs/draco/gltf/draco_wasm_wrapper.js?url';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { type GltfDocument, withBaseColors } from './gltfFile.js';
import { ModelError } from './ModelError.js';

/** The checked parts of a glTF file, in a form that a worker can post. */
export interface GltfParts {
  /** The name of the file. */
  name: string;
  document: GltfDocument;
  /** By their index in the document. */
  buffers: Uint8Array[];
  /** The images to be used, by their index in the document. */
  images: (Blob | undefined)[];
}

/** The scene of a model, and its clips. */
export interface ModelScene {
  root: Group;
  animations: AnimationClip[];
}

/** Parses a scene from its parts. Nothing else is fetched. */
export async function parseGltf({ name, document, buffers, images }: GltfParts): Promise<ModelScene> {
  const urls: string[] = [];
  const urlOf = (blob: Blob): string => {
    const url = URL.createObjectURL(blob);
    urls.push(url);
    return url;
  };
  const manager = new LoadingManager();
  manager.setURLModifier((url) => {
    if (/^(blob|data):/.test(url) || url === dracoUrls.js || url === dracoUrls.wasm) return url;
    throw new ModelError(`${name} refers to ${url}, which is not among the dropped files.`);
  });
  const loader = new GLTFLoader(manager);
  const draco = new DRACOLoader(manager).setDecoderPath(dracoUrls as never);
  loader.setDRACOLoader(draco);
  try {
    const { extensionsUsed = [], extensionsRequired = [] } = document;
    if ([...extensionsUsed, ...extensionsRequired].some((extension) => extension.endsWith('meshopt_compression'))) {
      const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
      loader.setMeshoptDecoder(MeshoptDecoder);
    }
    const placed = {
      ...withBaseColors(
        document,
        images.map((image) => image && urlOf(image)),
      ),
      buffers: buffers.map((buffer) => ({
        byteLength: buffer.length,
        uri: urlOf(new Blob([buffer as Uint8Array<ArrayBuffer>])),
      })),
    };
    const { scene, animations } = await loader.parseAsync(placed as never, '');
    return { root: scene, animations };
  } finally {
    draco.dispose();
    for (const url of urls) URL.revokeObjectURL(url);
  }
}

const dracoUrls = {
  js: new URL(dracoScriptUrl, import.meta.url).href,
  wasm: new URL(dracoWasmUrl, import.meta.url).href,
};
