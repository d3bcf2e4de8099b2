import {
  type BufferAttribute,
  type BufferGeometry,
  ClampToEdgeWrapping,
  type InterleavedBufferAttribute,
  type Interpolant,
  InterpolateDiscrete,
  type KeyframeTrack,
  type Material,
  Matrix4,
  type Mesh,
  type MeshPhongMaterial,
  MirroredRepeatWrapping,
  type Object3D,
  PropertyBinding,
  type SkinnedMesh,
  type Texture,
} from 'three';
import { ModelError } from '../common/ModelError.js';
import { baseName } from '../common/ModelFile.js';
import type { FindFile } from '../common/Surroundings.js';
import { chooseScene } from '../gltf/chooseScene.js';
import type { DracoSource } from '../gltf/GltfGeometry.js';
import type { AccessorValues } from '../gltf/GltfValues.js';
import type {
  GltfAnimationSampler,
  GltfChannel,
  GltfDocument,
  GltfMaterial,
  GltfTextureUse,
} from '../gltf/gltfDocument.js';
import { type ReadGltf, readParts } from '../gltf/readGltf.js';
import { farCentre } from '../mesh/fitModel.js';
import { normalizeNormals } from '../mesh/PlainMesh.js';
import type { PictureLink } from '../pictures/meshPictures.js';
import { mirroredBy, reflectedColor } from './mirroredBy.js';
import { orientScene } from './orientScene.js';

const noDraco: DracoSource = () => Promise.reject(new ModelError('A scene has nothing packed with Draco.'));

/** Larger scenes would not be animated anyway. */
const MAX_VERTICES = 300_000;

/** Vertices farther from their mesh's origin than this multiple of its size are too coarse in glTF's single precision. */
const MAX_DISTANCE = 1000;

/**
 * Reads an animated scene of one of three's loaders as the document of a glTF file, so that it is checked and drawn in the same way, from
 * both sides. Its arrays become those of the result.
 *
 * @param root with its clips
 * @param turns whether triangles that face the wrong way are turned
 * @returns `moving` is undefined if nothing moves, or the motion cannot be shown; `turned` is the number of triangles that were turned
 */
export async function readMoving(
  root: Object3D,
  name: string,
  findFile: FindFile,
  turns = false,
): Promise<{ moving: ReadGltf | undefined; turned: number }> {
  let turned = 0;
  if (countVertices(root) > MAX_VERTICES || isFar(root)) return { moving: undefined, turned };
  try {
    if (turns) turned = orientScene(root);
    const { document, values, embedded } = new SceneDocument(root);
    const findPicture: FindFile = async (uri) => {
      const inside = embedded.get(uri);
      return inside ? new Uint8Array(await inside.arrayBuffer()) : findFile(uri);
    };
    const chosen = chooseScene(document, name);
    const { plain, parts, read } = await readParts(document, chosen, values, name, findPicture, noDraco);
    const moves = parts && plain.json.animations.length > 0;
    return { moving: moves ? { ...read, content: { ...parts, hasBothSides: true } } : undefined, turned };
  } catch {
    // The scene is then shown at rest.
    return { moving: undefined, turned };
  }
}

const meshesOf = (root: Object3D): Mesh[] => root.getObjectsByProperty('isMesh', true) as Mesh[];

const countVertices = (root: Object3D): number =>
  meshesOf(root).reduce((sum, { geometry }) => sum + (geometry.getAttribute('position')?.count ?? 0), 0);

/** Whether a mesh's vertices lie far from its origin. */
const isFar = (root: Object3D): boolean =>
  meshesOf(root).some(({ geometry }) => {
    const position = geometry.getAttribute('position');
    return position !== undefined && farCentre(position.array, MAX_DISTANCE) !== undefined;
  });

type Attribute = BufferAttribute | InterleavedBufferAttribute;
type Channel = GltfChannel | undefined;

const NAMES: readonly (readonly [attribute: string, name: string])[] = [
  ['position', 'POSITION'],
  ['normal', 'NORMAL'],
  ['uv', 'TEXCOORD_0'],
  ['uv1', 'TEXCOORD_1'],
  ['uv2', 'TEXCOORD_2'],
  ['uv3', 'TEXCOORD_3'],
  ['color', 'COLOR_0'],
  ['skinIndex', 'JOINTS_0'],
  ['skinWeight', 'WEIGHTS_0'],
];
const PATHS: Readonly<Record<string, GltfChannel['target']['path']>> = {
  position: 'translation',
  quaternion: 'rotation',
  scale: 'scale',
};
const WRAPPINGS: Readonly<Record<number, number>> = { [ClampToEdgeWrapping]: 33071, [MirroredRepeatWrapping]: 33648 };
const REPEAT = 10497;

/** The values of a document that was made of a scene. */
class SceneValues implements AccessorValues {
  private readonly lists: { size: number; values: Float32Array | Uint32Array }[] = [];
  private readonly known = new Map<object, number>();

  /** @param key of values that are asked for again @returns the index of the accessor */
  add(key: object, size: number, make: () => Float32Array | Uint32Array): number {
    const index = this.known.get(key) ?? this.lists.push({ size, values: make() }) - 1;
    this.known.set(key, index);
    return index;
  }

  readonly sizeOf = (accessor: number): number => this.lists[accessor].size;
  readonly countOf = (accessor: number): number => this.lists[accessor].values.length / this.lists[accessor].size;
  readonly floatsOf = (accessor: number): Float32Array => this.lists[accessor].values as Float32Array;
  readonly tryFloats = this.floatsOf;
  readonly integersOf = (accessor: number): Uint32Array => this.lists[accessor].values as Uint32Array;
  readonly viewOf = (): never => {
    throw new ModelError('A scene has no buffer views.');
  };
}

/** A scene with its clips, as a glTF document. What does not move or is not drawn, such as lights and lines, is left out. */
class SceneDocument {
  readonly values = new SceneValues();
  /** Pictures that are embedded in the scene, by the URIs in the document. */
  readonly embedded = new Map<string, Blob>();
  readonly document: GltfDocument = {
    ...{ accessors: [], bufferViews: [], buffers: [], cameras: [], lights: [], variants: [] },
    ...{ nodes: [], meshes: [], skins: [], materials: [], textures: [], images: [], samplers: [], animations: [] },
    scenes: [{ nodes: [0] }],
    scene: 0,
  };
  private readonly nodes = new Map<Object3D, number>();
  private readonly meshes = new Map<string, number>();
  private readonly materials = new Map<Material, number>();
  private readonly images = new Map<string, number>();

  constructor(root: Object3D) {
    const { document, nodes } = this;
    this.addNode(root);
    for (const [object, node] of nodes)
      if ('isSkinnedMesh' in object)
        document.nodes[node].skin = document.skins.push(this.skinOf(object as SkinnedMesh)) - 1;
    document.animations = root.animations.map(({ name, tracks }) => {
      const samplers: GltfAnimationSampler[] = [];
      const channels: Channel[] = this.tracksOf(root, tracks).map((track) => {
        if (!track) return undefined;
        const sampler = samplers.push(this.samplerOf(track)) - 1;
        return { sampler, target: { node: track.node, path: track.path } };
      });
      return { name, channels, samplers };
    });
  }

  /** Adds an object with all that is visible below it. */
  private addNode(object: Object3D): number | undefined {
    if (!object.visible || 'isLight' in object || 'isCamera' in object) return undefined;
    const { document, nodes } = this;
    const node: GltfDocument['nodes'][number] = {
      name: object.name,
      translation: finite(object.position.toArray()),
      rotation: finite(object.quaternion.toArray()),
      scale: finite(object.scale.toArray()),
    };
    const index = document.nodes.push(node) - 1;
    nodes.set(object, index);
    if ('isMesh' in object) node.mesh = this.meshOf(object as Mesh);
    node.children = object.children.map((child) => this.addNode(child)).filter((child) => child !== undefined);
    return index;
  }

  private meshOf(mesh: Mesh): number {
    const { geometry, material, name, morphTargetInfluences = [], morphTargetDictionary = {} } = mesh;
    const several = Array.isArray(material);
    const key = [geometry, ...[material].flat()].map((one) => one?.uuid).join();
    const known = this.meshes.get(key);
    if (known !== undefined) return known;
    const attributes: Record<string, number> = {};
    for (const [attribute, written] of NAMES) {
      const values = geometry.getAttribute(attribute) as Attribute | undefined;
      if (!values || (attribute === 'normal' && !hasDirections(floatsOf(values)))) continue;
      const read = () => (attribute === 'normal' ? normalizeNormals(floatsOf(values).slice()) : floatsOf(values));
      attributes[written] = this.values.add(values, values.itemSize, read);
    }
    const targets = morphTargetInfluences.map((_, i) => this.targetOf(geometry, i, attributes.NORMAL !== undefined));
    const primitives = (several ? geometry.groups : [{ start: 0, count: Infinity, materialIndex: 0 }]).map((group) => {
      const drawn = several ? material[group.materialIndex ?? 0] : material;
      return {
        attributes,
        ...(targets.length > 0 && { targets }),
        indices: this.addIndices(geometry, group),
        ...(drawn && { material: this.materialOf(drawn as MeshPhongMaterial) }),
      };
    });
    const names: string[] = [];
    for (const [target, i] of Object.entries(morphTargetDictionary)) names[i] = target;
    const index = this.document.meshes.push({
      name,
      primitives,
      ...(targets.length > 0 && { weights: finite(morphTargetInfluences) }),
      ...(names.length > 0 && { extras: { targetNames: Array.from(names, (target, i) => target ?? String(i)) } }),
    });
    this.meshes.set(key, index - 1);
    return index - 1;
  }

  /** Adds the corners of a group; undefined if all vertices are corners, in order. */
  private addIndices(
    { index, attributes: { position } }: BufferGeometry,
    group: { start: number; count: number },
  ): number | undefined {
    const end = Math.min(index?.count ?? position?.count ?? 0, group.start + group.count);
    const count = Math.max(0, end - group.start);
    if (!index && count === position?.count) return undefined;
    return this.values.add(group, 1, () =>
      Uint32Array.from({ length: count }, (_, i) => index?.getX(group.start + i) ?? group.start + i),
    );
  }

  /** The attributes of a morph target, relative to those of the mesh. */
  private targetOf(
    { attributes, morphAttributes, morphTargetsRelative }: BufferGeometry,
    i: number,
    hasNormals: boolean,
  ) {
    const written: Record<string, number> = {};
    for (const name of hasNormals ? (['position', 'normal'] as const) : (['position'] as const)) {
      const target = morphAttributes[name]?.[i] as Attribute | undefined;
      const base = attributes[name] as Attribute;
      if (!target) continue;
      written[name.toUpperCase()] = this.values.add(target, 3, () => {
        const moved = floatsOf(target);
        const still = morphTargetsRelative ? undefined : floatsOf(base);
        return still ? moved.map((value, k) => value - still[k]) : moved;
      });
    }
    return written;
  }

  private materialOf(material: MeshPhongMaterial): number {
    const known = this.materials.get(material);
    if (known !== undefined) return known;
    const { name, opacity, transparent, alphaTest, map } = material;
    const color = reflectedColor(material);
    const metallicFactor = mirroredBy(material);
    const factor = [...(color?.toArray() ?? [1, 1, 1]), opacity];
    const texture = map?.image ? this.textureOf(map) : undefined;
    const plain: GltfMaterial = {
      name,
      ...(transparent ? { alphaMode: 'BLEND' } : alphaTest > 0 && { alphaMode: 'MASK', alphaCutoff: alphaTest }),
      pbrMetallicRoughness: {
        ...(factor.every(Number.isFinite) && { baseColorFactor: factor }),
        ...(texture && { baseColorTexture: texture }),
        ...(metallicFactor > 0 && { metallicFactor, roughnessFactor: 0 }),
      },
    };
    const index = this.document.materials.push(plain) - 1;
    this.materials.set(material, index);
    return index;
  }

  /** Turns the picture over: pictures in glTF begin at the top, those of most loaders at the bottom. */
  private textureOf({ image, wrapS, wrapT, offset, repeat, flipY }: Texture): GltfTextureUse {
    const { images, samplers, textures } = this.document;
    const { url, content } = image as PictureLink;
    const source = this.images.get(url) ?? images.length;
    if (source === images.length) {
      const path = url.startsWith('data:') ? url : baseName(url).replaceAll('%', '%25');
      const uri = content ? `picture-${source}` : path;
      if (content) this.embedded.set(uri, content);
      images.push({ uri });
      this.images.set(url, source);
    }
    const [s, t] = [wrapS, wrapT].map((wrap) => WRAPPINGS[wrap] ?? REPEAT);
    const sampler = samplers.push({ wrapS: s, wrapT: t }) - 1;
    const index = textures.push({ source, sampler }) - 1;
    const placed = flipY
      ? { offset: [offset.x, 1 - offset.y], scale: [repeat.x, -repeat.y] }
      : { offset: [offset.x, offset.y], scale: [repeat.x, repeat.y] };
    return { index, extensions: { KHR_texture_transform: placed } };
  }

  /** The skin of a mesh; undefined if a bone is not shown. */
  private skinOf({ skeleton, bindMatrix }: SkinnedMesh): GltfDocument['skins'][number] {
    const joints = skeleton?.bones.map((bone) => this.nodes.get(bone)) ?? [];
    if (!joints.every((joint) => joint !== undefined)) return undefined;
    const matrix = new Matrix4();
    const inverses = new Float32Array(16 * joints.length);
    for (const [i, inverse] of skeleton.boneInverses.entries())
      matrix.multiplyMatrices(inverse, bindMatrix).toArray(inverses, 16 * i);
    return { joints, inverseBindMatrices: this.values.add(inverses, 16, () => inverses) };
  }

  /** The tracks of a clip, with those of one mesh's morph targets together; undefined for a track without a visible target. */
  private tracksOf(root: Object3D, tracks: readonly KeyframeTrack[]): (NodeTracks | undefined)[] {
    const found: (NodeTracks | undefined)[] = [];
    const ofShapes = new Map<Object3D, NodeTracks>();
    for (const track of tracks) {
      const { nodeName, objectName, objectIndex, propertyName, propertyIndex } = PropertyBinding.parseTrackName(
        track.name,
      );
      const target = PropertyBinding.findNode(root, nodeName) as SkinnedMesh | null;
      const object = objectName === 'bones' ? target?.skeleton?.getBoneByName(objectIndex) : target;
      const node = object ? this.nodes.get(object) : undefined;
      const isShape = propertyName === 'morphTargetInfluences';
      const path = isShape ? 'weights' : PATHS[propertyName];
      const { morphTargetInfluences: weights = [], morphTargetDictionary: names = {} } = target ?? {};
      const shape = isShape ? (names[propertyIndex] ?? Number(propertyIndex)) : 0;
      if (!object || node === undefined || !path || (isShape && weights[shape] === undefined)) found.push(undefined);
      else if (!isShape) found.push({ node, path, tracks: [track], weights: [] });
      else {
        let together = ofShapes.get(object);
        if (!together) {
          together = { node, path, tracks: [], weights };
          ofShapes.set(object, together);
          found.push(together);
        }
        together.tracks[shape] = track;
      }
    }
    return found;
  }

  private samplerOf({ tracks, path, weights }: NodeTracks): GltfAnimationSampler {
    const given = tracks.filter(Boolean);
    const [track] = given;
    const isStepped = given.every((one) => one.getInterpolation() === InterpolateDiscrete);
    let { times, values } = track;
    if (path === 'weights') {
      times = Float32Array.from([...new Set(given.flatMap((one) => [...one.times]))].sort((a, b) => a - b));
      const read = weights.map((weight, shape) => {
        const interpolant = (tracks[shape] as Interpolated | undefined)?.createInterpolant();
        return (time: number): number => (interpolant ? interpolant.evaluate(time)[0] : weight);
      });
      values = Float32Array.from([...times].flatMap((time) => read.map((at) => at(time))));
    }
    const size = path === 'weights' ? 1 : path === 'rotation' ? 4 : 3;
    return {
      input: this.values.add(times, 1, () => times),
      output: this.values.add(values, size, () => values),
      interpolation: isStepped ? 'STEP' : 'LINEAR',
    };
  }
}

/** A member of tracks that the types of three.js lack. */
type Interpolated = KeyframeTrack & { createInterpolant(): Interpolant };

/** Tracks of one property of a node: one, or one per morph target that moves. */
interface NodeTracks {
  node: number;
  path: GltfChannel['target']['path'];
  tracks: KeyframeTrack[];
  /** Of the morph targets at rest. */
  weights: readonly number[];
}

/** The values of an attribute in single precision; its own array if it is one of that kind. */
function floatsOf(attribute: Attribute): Float32Array {
  const { array, count, itemSize } = attribute;
  const isWhole = array.length === count * itemSize && array.byteLength === array.buffer.byteLength;
  if (array instanceof Float32Array && isWhole && !('isInterleavedBufferAttribute' in attribute)) return array;
  return Float32Array.from({ length: count * itemSize }, (_, i) =>
    attribute.getComponent(Math.floor(i / itemSize), i % itemSize),
  );
}

/** Whether all normals have a direction; otherwise they are computed from the surface. */
function hasDirections(normals: Float32Array): boolean {
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    if (!(length > 0 && length < Infinity)) return false;
  }
  return true;
}

/** @throws Error if a number is not finite */
function finite(numbers: number[]): number[] {
  if (numbers.every(Number.isFinite)) return numbers;
  throw new Error('The scene has numbers that are not finite.');
}
