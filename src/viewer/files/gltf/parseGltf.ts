import {
  type AnimationClip,
  ClampToEdgeWrapping,
  DoubleSide,
  type Group,
  type InstancedMesh,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearMipmapNearestFilter,
  type Mesh,
  MirroredRepeatWrapping,
  NearestFilter,
  NearestMipmapLinearFilter,
  NearestMipmapNearestFilter,
  type Object3D,
  RepeatWrapping,
  Texture,
} from 'three';
import { GLTFLoader, type GLTFLoaderPlugin, type GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { Slices } from '../common/Slices.js';
import type { DecodedPicture } from '../common/Surroundings.js';
import { leaveOutCeiling, type SceneCeiling } from '../scenes/sceneCeiling.js';
import { fitWeights } from './GltfGeometry.js';
import type { GltfSampler } from './gltfDocument.js';
import type { Picture } from './gltfMaterials.js';

/**
 * Gives instanced meshes their morph target influences, which three's loader omits: the renderer throws an error where a geometry has morph
 * targets and its mesh has no influences. All instances of a mesh share one pose.
 */
class InstanceShapes implements GLTFLoaderPlugin {
  readonly name = 'instance shapes';

  constructor(private readonly parser: GLTFParser) {}

  /** Runs before the loader binds clips to their targets. */
  async loadNode(index: number): Promise<Object3D> {
    const node = await this.parser.loadNode(index);
    const { nodes, meshes } = this.parser.json;
    const mesh = meshes[nodes[index].mesh];
    const names: string[] | undefined = mesh?.extras?.targetNames;
    // A mesh of several primitives is a group. Children of other nodes have influences already.
    for (const part of [node, ...node.children]) {
      if (!isShapeless(part)) continue;
      const shapes = Object.values(part.geometry.morphAttributes)[0]?.length ?? 0;
      part.morphTargetInfluences = fitWeights(nodes[index].weights ?? mesh.weights ?? [], shapes);
      part.morphTargetDictionary = Object.fromEntries(
        part.morphTargetInfluences.map((_, i) => [names?.[i] ?? String(i), i]),
      );
    }
    return node;
  }
}

/** Whether an object is an instanced mesh with morph targets but without influences. */
function isShapeless(object: Object3D): object is InstancedMesh {
  if (!('isInstancedMesh' in object)) return false;
  const { geometry, morphTargetInfluences } = object as InstancedMesh;
  return Object.keys(geometry.morphAttributes).length > 0 && !morphTargetInfluences;
}

/** The checked parts of a glTF file, in a form that a worker can post. */
export interface GltfParts {
  /** An uncompressed document, whose buffer views are the arrays. */
  json: object;
  arrays: ArrayBuffer[];
  /** The image and sampler of each texture. */
  textures: { image: number; sampler: GltfSampler | undefined }[];
  /** Pictures to decode, by image index. */
  pictures: (Picture | undefined)[];
  /** Decoded pictures, by image index. */
  bitmaps: (DecodedPicture | undefined)[];
  /** Whether both sides of all surfaces are drawn, whatever their materials say. */
  hasBothSides: boolean;
  /** The ceiling of its closed rooms, which is left out. */
  ceiling?: SceneCeiling;
}

/** The scene of a model, and its clips. */
export interface ModelScene {
  root: Group;
  animations: AnimationClip[];
}

/** Creates a scene from the parts of a file, in time slices. Fetches and decodes nothing. Rejects with the signal's reason. */
export async function parseGltf(parts: GltfParts, signal?: AbortSignal): Promise<ModelScene> {
  const slices = new Slices(signal);
  const loader = new GLTFLoader()
    .register((parser) => new PartsPlugin(parser, parts, slices))
    .register((parser) => new InstanceShapes(parser));
  const { scene, animations } = await loader.parseAsync(parts.json as never, '');
  if (parts.hasBothSides) scene.traverse(drawBothSides);
  if (parts.ceiling) leaveOutCeiling(scene, parts.ceiling);
  return { root: scene, animations };
}

function drawBothSides(object: Object3D): void {
  for (const material of [(object as Partial<Mesh>).material ?? []].flat()) material.side = DoubleSide;
}

/** Supplies three's loader with the arrays and pictures that it would otherwise load. */
class PartsPlugin implements GLTFLoaderPlugin {
  readonly name = 'parts';
  /** The most recently requested mesh. */
  private latest: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly parser: GLTFParser,
    private readonly parts: GltfParts,
    private readonly slices: Slices,
  ) {}

  /** Creates meshes one at a time with pauses; three's loader requests thousands at once, and would create them in one task. */
  loadMesh(index: number): ReturnType<GLTFParser['loadMesh']> {
    const mesh = this.latest.then(() => this.slices.next()).then(() => this.parser.loadMesh(index));
    this.latest = mesh.catch(() => {});
    return mesh;
  }

  async loadBufferView(index: number): Promise<ArrayBuffer> {
    return this.parts.arrays[index];
  }

  async loadTexture(index: number): Promise<Texture> {
    const { image, sampler = {} } = this.parts.textures[index];
    const texture = new Texture(this.parts.bitmaps[image] as ImageBitmap | undefined);
    texture.flipY = false;
    texture.magFilter = sampler.magFilter === 9728 ? NearestFilter : LinearFilter;
    texture.minFilter = MIN_FILTERS[sampler.minFilter ?? 0] ?? LinearMipmapLinearFilter;
    texture.wrapS = WRAPPINGS[sampler.wrapS ?? 0] ?? RepeatWrapping;
    texture.wrapT = WRAPPINGS[sampler.wrapT ?? 0] ?? RepeatWrapping;
    texture.generateMipmaps = texture.minFilter !== NearestFilter && texture.minFilter !== LinearFilter;
    texture.needsUpdate = true;
    this.parser.associations.set(texture, { textures: index });
    return texture;
  }
}

/** Maps WebGL's constants to those of three.js. */
const MIN_FILTERS: Record<number, Texture['minFilter']> = {
  9728: NearestFilter,
  9729: LinearFilter,
  9984: NearestMipmapNearestFilter,
  9985: LinearMipmapNearestFilter,
  9986: NearestMipmapLinearFilter,
  9987: LinearMipmapLinearFilter,
};
const WRAPPINGS: Record<number, Texture['wrapS']> = {
  33071: ClampToEdgeWrapping,
  33648: MirroredRepeatWrapping,
  10497: RepeatWrapping,
};
