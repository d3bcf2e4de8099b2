import { ModelError } from './ModelError.js';

/** The parts of a glTF document this page reads or checks. */
export interface GltfDocument {
  asset?: { version?: string };
  extensionsRequired?: string[];
  accessors?: { bufferView?: number; count?: number; sparse?: unknown }[];
  bufferViews?: { buffer?: number; byteOffset?: number; byteLength?: number; extensions?: object }[];
  buffers?: { uri?: string; byteLength?: number; extensions?: object }[];
  nodes?: { children?: number[] }[];
  materials?: GltfMaterial[];
  textures?: unknown;
  images?: unknown;
  samplers?: unknown;
  animations?: unknown;
}

interface GltfMaterial {
  name?: string;
  alphaMode?: string;
  doubleSided?: boolean;
  pbrMetallicRoughness?: { baseColorFactor?: number[] };
}

const GLB_JSON = 0x4e4f534a;
const GLB_BINARY = 0x004e4942;
/** Accessors without a buffer view are zeros a few bytes of text can ask a gigabyte of. */
const MAX_IMPLIED_VALUES = 1_000_000;
const MAX_NODES = 100_000;
const MAX_DEPTH = 500;
const READABLE =
  /^(KHR_draco_mesh_compression|EXT_meshopt_compression|KHR_meshopt_compression|KHR_mesh_quantization|EXT_mesh_gpu_instancing|(KHR|EXT)_(texture|materials|lights)_\w+|KHR_node_visibility)$/;

/** Splits a GLB file into its document and its binary part. */
export function splitGlb(bytes: Uint8Array, name: string): { text: string; binary: Uint8Array | undefined } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20) throw new ModelError(`${name} is cut short: it ends within its header.`);
  const version = view.getUint32(4, true);
  if (version !== 2) throw new ModelError(`${name} is glTF version ${version}; this page reads version 2.`);
  if (view.getUint32(8, true) > bytes.length) {
    throw new ModelError(
      `${name} is cut short: it should have ${view.getUint32(8, true).toLocaleString('en')} bytes and has ${bytes.length.toLocaleString('en')}.`,
    );
  }
  let text: string | undefined;
  let binary: Uint8Array | undefined;
  for (let offset = 12; offset + 8 <= bytes.length; ) {
    const length = view.getUint32(offset, true);
    const kind = view.getUint32(offset + 4, true);
    const chunk = bytes.subarray(offset + 8, offset + 8 + length);
    if (chunk.length < length) throw new ModelError(`${name} is cut short: one of its parts ends too early.`);
    if (kind === GLB_JSON) text ??= new TextDecoder().decode(chunk);
    else if (kind === GLB_BINARY) binary ??= chunk;
    offset += 8 + length;
  }
  if (text === undefined) throw new ModelError(`${name} has no description of its scene.`);
  return { text, binary };
}

/** Parses the text of a glTF document and refuses what cannot be read, in words. */
export function readGltfDocument(text: string, name: string): GltfDocument {
  let gltf: GltfDocument;
  try {
    gltf = JSON.parse(text) as GltfDocument;
  } catch {
    throw new ModelError(`${name} is damaged: its description is not valid JSON.`);
  }
  const version = gltf?.asset?.version;
  if (typeof version !== 'string') throw new ModelError(`${name} is not a glTF file: it does not say its version.`);
  if (!version.startsWith('2')) throw new ModelError(`${name} is glTF version ${version}; this page reads version 2.`);
  const unknown = gltf.extensionsRequired?.find((extension) => !READABLE.test(extension));
  if (unknown) throw new ModelError(`${name} needs the glTF extension ${unknown}, which this page does not read.`);
  const implied = (gltf.accessors ?? []).reduce((sum, a) => sum + (a.bufferView === undefined ? (a.count ?? 0) : 0), 0);
  const isCompressed = gltf.extensionsRequired?.includes('KHR_draco_mesh_compression') ?? false;
  if (implied > MAX_IMPLIED_VALUES && !isCompressed)
    throw new ModelError(`${name} asks for more memory than its content explains.`);
  checkNodes(gltf, name);
  return gltf;
}

/** Checks that every buffer holds what its views ask of it. */
export function checkBufferViews(gltf: GltfDocument, sizes: readonly number[], name: string): void {
  for (const view of gltf.bufferViews ?? []) {
    if (view.extensions || gltf.buffers?.[view.buffer ?? -1]?.extensions) continue;
    const size = sizes[view.buffer ?? -1];
    if (size === undefined || (view.byteOffset ?? 0) + (view.byteLength ?? 0) > size) {
      throw new ModelError(`${name} is cut short: its buffer ends before the data it lists.`);
    }
  }
}

/** Takes pictures and animations out: they are not drawn, and decoding them could cost more than the model. */
export function withoutPictures(gltf: GltfDocument): GltfDocument {
  const { textures: _textures, images: _images, samplers: _samplers, animations: _animations, ...rest } = gltf;
  const materials = gltf.materials?.map(({ name, alphaMode, doubleSided, pbrMetallicRoughness }) => {
    const factor = pbrMetallicRoughness?.baseColorFactor;
    return { name, alphaMode, doubleSided, pbrMetallicRoughness: factor ? { baseColorFactor: factor } : {} };
  });
  return materials ? { ...rest, materials: materials as GltfMaterial[] } : rest;
}

function checkNodes(gltf: GltfDocument, name: string): void {
  const nodes = gltf.nodes ?? [];
  if (nodes.length > MAX_NODES)
    throw new ModelError(`${name} has ${nodes.length.toLocaleString('en')} nodes, too many for a page.`);
  const depths = new Int32Array(nodes.length).fill(-1);
  const parents = new Uint8Array(nodes.length);
  for (const node of nodes) for (const child of node.children ?? []) if (child < nodes.length) parents[child]!++;
  const pending = nodes.flatMap((_, i) => (parents[i] === 0 ? [{ node: i, depth: 0 }] : []));
  let reached = 0;
  while (pending.length > 0) {
    const { node, depth } = pending.pop()!;
    if (depths[node] !== -1) continue;
    depths[node] = depth;
    reached++;
    if (depth > MAX_DEPTH) throw new ModelError(`${name} nests its nodes more than ${MAX_DEPTH} deep.`);
    for (const child of nodes[node]!.children ?? []) pending.push({ node: child, depth: depth + 1 });
  }
  if (reached < nodes.length) throw new ModelError(`${name} is damaged: some of its nodes contain themselves.`);
}
