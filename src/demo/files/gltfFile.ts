import { ModelError } from './ModelError.js';

/** The parts of a glTF document that are read or checked here. */
export interface GltfDocument {
  asset?: { version?: string };
  extensionsRequired?: string[];
  extensionsUsed?: string[];
  accessors?: { bufferView?: number; count?: number; sparse?: unknown }[];
  bufferViews?: { buffer?: number; byteOffset?: number; byteLength?: number; extensions?: object }[];
  buffers?: { uri?: string; byteLength?: number; extensions?: object }[];
  nodes?: { children?: number[] }[];
  meshes?: { primitives?: { attributes?: { POSITION?: number }; targets?: unknown[] }[] }[];
  skins?: unknown[];
  materials?: GltfMaterial[];
  textures?: { source?: number; sampler?: number; extensions?: { EXT_texture_webp?: { source?: number } } }[];
  images?: { uri?: string; bufferView?: number; mimeType?: string }[];
  samplers?: unknown;
  animations?: { channels?: unknown[] }[];
}

interface GltfMaterial {
  name?: string;
  alphaMode?: string;
  alphaCutoff?: number;
  doubleSided?: boolean;
  pbrMetallicRoughness?: { baseColorFactor?: number[]; baseColorTexture?: { index?: number } };
}

const GLB_JSON = 0x4e4f534a;
const GLB_BINARY = 0x004e4942;
/** An accessor without a buffer view is filled with zeros: a few bytes of text could ask for gigabytes. */
const MAX_IMPLIED_VALUES = 1_000_000;
const MAX_NODES = 100_000;
const MAX_DEPTH = 500;
/** Larger scenes would block the main thread for too long. They are merged to one mesh, which does not move. */
const MAX_SCENE = { vertices: 300_000, nodes: 5_000, channels: 20_000 };
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

/** Parses the text of a glTF document. @throws ModelError if it cannot be read */
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
  const implied = sum(gltf.accessors ?? [], ({ bufferView, count }) => (bufferView === undefined ? (count ?? 0) : 0));
  const isCompressed = gltf.extensionsRequired?.includes('KHR_draco_mesh_compression') ?? false;
  if (implied > MAX_IMPLIED_VALUES && !isCompressed)
    throw new ModelError(`${name} asks for more memory than its content explains.`);
  checkNodes(gltf, name);
  return gltf;
}

/** Checks that every buffer view lies within its buffer. @throws ModelError */
export function checkBufferViews(gltf: GltfDocument, sizes: readonly number[], name: string): void {
  for (const view of gltf.bufferViews ?? []) {
    if (view.extensions || gltf.buffers?.[view.buffer ?? -1]?.extensions) continue;
    const size = sizes[view.buffer ?? -1];
    if (size === undefined || (view.byteOffset ?? 0) + (view.byteLength ?? 0) > size) {
      throw new ModelError(`${name} is cut short: its buffer ends before the data it lists.`);
    }
  }
}

/**
 * Whether a document is drawn as a scene: it has animation or textures, which one merged mesh cannot show, and it is
 * small enough to be parsed on the main thread.
 */
export function isDrawnAsScene(gltf: GltfDocument): boolean {
  const primitives = (gltf.meshes ?? []).flatMap((mesh) => mesh.primitives ?? []);
  const channels = sum(gltf.animations ?? [], (animation) => animation.channels?.length ?? 0);
  const moves = channels > 0 || (gltf.skins?.length ?? 0) > 0 || primitives.some(({ targets }) => targets?.length);
  const isPictured = (gltf.materials ?? []).some((material) => material.pbrMetallicRoughness?.baseColorTexture);
  const vertices = sum(primitives, ({ attributes }) => gltf.accessors?.[attributes?.POSITION ?? -1]?.count ?? 0);
  const isSmall =
    vertices <= MAX_SCENE.vertices &&
    (gltf.nodes?.length ?? 0) <= MAX_SCENE.nodes &&
    channels <= MAX_SCENE.channels &&
    vertices > 0;
  return Boolean(moves || isPictured) && isSmall;
}

/** The index of a texture's image. */
export function textureSource(gltf: GltfDocument, texture: number | undefined): number | undefined {
  const { source, extensions } = gltf.textures?.[texture ?? -1] ?? {};
  return source ?? extensions?.EXT_texture_webp?.source;
}

/**
 * Reduces the materials of a document to their base colours, alpha and sides.
 *
 * @param urls of the images, by index; images without one are left out
 */
export function withBaseColors(gltf: GltfDocument, urls: readonly (string | undefined)[]): GltfDocument {
  const isThere = (texture: number | undefined): boolean => urls[textureSource(gltf, texture) ?? -1] !== undefined;
  const materials = gltf.materials?.map(({ name, alphaMode, alphaCutoff, doubleSided, pbrMetallicRoughness }) => {
    const { baseColorFactor, baseColorTexture } = pbrMetallicRoughness ?? {};
    return {
      name,
      alphaMode,
      alphaCutoff,
      doubleSided,
      pbrMetallicRoughness: {
        ...(baseColorFactor && { baseColorFactor }),
        ...(isThere(baseColorTexture?.index) && { baseColorTexture }),
      },
    };
  });
  return {
    ...gltf,
    ...(materials && { materials: materials as GltfMaterial[] }),
    images: urls.map((uri) => ({ uri: uri ?? '' })),
    textures: (gltf.textures ?? []).map(({ sampler }, i) => ({ sampler, source: textureSource(gltf, i) })),
  };
}

const sum = <Item>(items: readonly Item[], value: (item: Item) => number): number =>
  items.reduce((total, item) => total + value(item), 0);

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
    for (const child of nodes[node].children ?? []) pending.push({ node: child, depth: depth + 1 });
  }
  if (reached < nodes.length) throw new ModelError(`${name} is damaged: some of its nodes contain themselves.`);
}
