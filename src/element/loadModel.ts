import {
  FileLoader,
  LoaderUtils,
  type Material,
  type Mesh,
  type Object3D,
  type OrthographicCamera,
  type PerspectiveCamera,
  type SkinnedMesh,
  type Texture,
} from 'three';
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { ModelSource } from './decoders.js';
import { readExtensions } from './readExtensions.js';

const NAME = 'KHR_materials_variants';

interface Variants {
  variants?: { name?: string }[];
}

interface Mappings {
  mappings?: { material: number; variants: number[] }[];
}

/** Sets the materials of a variant on the meshes of a model. @throws Error that lists all variants, if there is none of this name */
async function useVariant({ scene, parser }: GLTF, wanted: string): Promise<void> {
  const { variants = [] } = (parser.json.extensions?.[NAME] ?? {}) as Variants;
  const names = variants.map(({ name }, i) => [name ?? `Variant ${i + 1}`]);
  const index = chosenIndex('variant', names, wanted);
  const meshes: [mesh: Mesh, material: number][] = [];
  scene.traverse((object) => {
    const { mappings = [] } = (object.userData.gltfExtensions?.[NAME] ?? {}) as Mappings;
    const mapping = mappings.find((one) => one.variants.includes(index));
    if (mapping && 'isMesh' in object) meshes.push([object as Mesh, mapping.material]);
  });
  for (const [mesh, material] of meshes) {
    mesh.material = (await parser.getDependency('material', material)) as Material;
    parser.assignFinalMaterial(mesh);
  }
}

/** A camera of a model, and the names by which it can be selected. */
export interface NamedCamera {
  names: string[];
  camera: PerspectiveCamera | OrthographicCamera;
}

export interface LoadedModel {
  scene: Object3D;
  cameras: NamedCamera[];
}

/** The extensions that need decoders. Decoders are loaded only when needed: they are large, and strict policies forbid WebAssembly. */
const PACKED = /^(KHR_draco_mesh_compression|(EXT|KHR)_meshopt_compression|KHR_texture_basisu)$/;

/**
 * Loads a glTF or GLB file.
 *
 * @throws Error whose message is a sentence for the reader of the page
 */
export async function loadModel(source: ModelSource): Promise<LoadedModel> {
  const { address } = source;
  let giveBack: (() => void) | undefined;
  try {
    const content = (await new FileLoader().setResponseType('arraybuffer').loadAsync(address)) as ArrayBuffer;
    const loader = new GLTFLoader();
    const extensions = readExtensions(content);
    if (extensions.used.some((name) => PACKED.test(name))) {
      giveBack = await (await import('./decoders.js')).addDecoders(loader, extensions, source);
    }
    const gltf = await loader.parseAsync(content, LoaderUtils.extractUrlBase(address));
    if (source.variant) await useVariant(gltf, source.variant);
    return { scene: gltf.scene, cameras: camerasOf(gltf) };
  } catch (cause) {
    throw new Error(sentenceOf('model', address, cause), { cause });
  } finally {
    giveBack?.();
  }
}

/** The cameras in the scene of a model, with the names by which they can be selected. */
function camerasOf({ scene, parser }: GLTF): NamedCamera[] {
  const cameras: NamedCamera[] = [];
  scene.traverse((object) => {
    if (!('isCamera' in object)) return;
    const { nodes = -1 } = parser.associations.get(object) ?? {};
    const node = parser.json.nodes?.[nodes] ?? {};
    const names = [parser.json.cameras?.[node.camera]?.name, node.name, `Camera ${cameras.length + 1}`];
    cameras.push({ names: names.filter(Boolean), camera: object as NamedCamera['camera'] });
  });
  return cameras;
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

/**
 * Why something could not be loaded, for the reader of the page.
 *
 * @param what it is, such as `model`
 */
export function sentenceOf(what: string, address: string, cause: unknown): string {
  const message = messageOf(cause);
  const name = address.startsWith('data:') ? 'of the page' : `"${address.split(/[?#]/)[0].split('/').at(-1)}"`;
  const status = /responded with (\d+)/.exec(message)?.[1];
  if (status) return `The ${what} ${name} could not be fetched: the server answered ${status}.`;
  if (/failed to fetch|networkerror|load failed/i.test(message)) {
    return `The ${what} ${name} could not be fetched: the server does not answer, or forbids it.`;
  }
  return `The ${what} ${name} could not be read: ${message}`;
}

/** The message of an error. Draco's workers throw plain objects. */
const messageOf = (cause: unknown): string =>
  cause instanceof Error ? cause.message : String((cause as { error?: unknown } | undefined)?.error ?? cause);

/**
 * The index of the item that an attribute selects.
 *
 * @param kind the kind of the items, for error messages
 * @param wanted a name, or a number from 1 on
 * @throws Error that lists all items, if none is selected
 */
export function chosenIndex(kind: string, names: readonly (readonly string[])[], wanted: string): number {
  const named = names.findIndex((all) => all.includes(wanted));
  if (named !== -1) return named;
  const number = Number(wanted);
  if (Number.isInteger(number) && number >= 1 && number <= names.length) return number - 1;
  const known = names.map(([first]) => first).join(', ');
  throw new Error(`The model has no ${kind} "${wanted}". ${known ? `There are ${known}.` : 'It has none.'}`);
}
