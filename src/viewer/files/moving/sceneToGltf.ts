import {
  type AnimationClip,
  BufferAttribute,
  type BufferGeometry,
  Group,
  InterpolateDiscrete,
  InterpolateLinear,
  type KeyframeTrack,
  type Material,
  type Mesh,
  type MeshPhongMaterial,
  MeshStandardMaterial,
  type Object3D,
  PropertyBinding,
  Uint16BufferAttribute,
} from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { GltfPictureWriter } from './GltfPictureWriter.js';

/** Stands in for `FileReader`, which three's glTF exporter needs and Node lacks. */
class BlobReader {
  result: ArrayBuffer | null = null;
  onloadend: (() => void) | null = null;

  async readAsArrayBuffer(blob: Blob): Promise<void> {
    this.result = await blob.arrayBuffer();
    this.onloadend?.();
  }
}

/** Values per key by animated property. */
const VALUES_PER_KEY: Readonly<Record<string, number>> = {
  position: 3,
  quaternion: 4,
  scale: 3,
  morphTargetInfluences: 1,
};

/** A scene as glTF. */
export interface WrittenScene {
  glb: Uint8Array;
  /** Embedded pictures, by the URIs in the document. */
  pictures: ReadonlyMap<string, Blob>;
  /** The number of tracks that cannot be played. */
  leftOut: number;
}

/**
 * Converts a scene of one of three's loaders, with its clips, to glTF, so that it is checked and drawn in the same way. Materials are
 * converted; invisible objects are left out. The scene is changed and unusable afterwards.
 *
 * @throws Error of the exporter
 */
export async function sceneToGltf(root: Object3D): Promise<WrittenScene> {
  const holder = new Group().add(root);
  const pictures = new GltfPictureWriter();
  const materials = new Map<Material, MeshStandardMaterial>();
  const plain = (material: Material): MeshStandardMaterial => {
    if (!materials.has(material)) materials.set(material, plainMaterial(material as MeshPhongMaterial, pictures));
    return materials.get(material)!;
  };
  holder.traverse((object) => {
    makePlain(object);
    const { material } = object as Partial<Mesh>;
    if (material) (object as Mesh).material = Array.isArray(material) ? material.map(plain) : plain(material);
  });
  let leftOut = 0;
  for (const clip of root.animations) {
    const playable = clip.tracks.filter((track) => isPlayable(track, holder));
    leftOut += clip.tracks.length - playable.length;
    clip.tracks = playable;
    clip.userData = {};
  }
  const animations: AnimationClip[] = root.animations.filter(({ tracks }) => tracks.length > 0);
  // Loaders attach clips to several objects.
  holder.traverse((object) => {
    object.animations = [];
  });
  const exporter = new GLTFExporter().register((writer) => pictures.plugin(writer as never));
  const glb = await withReader(() => exporter.parseAsync(holder, { binary: true, animations }));
  return { glb: new Uint8Array(glb as ArrayBuffer), pictures: pictures.written, leftOut };
}

/** Runs the exporter with a `FileReader` of our own where there is none. */
async function withReader<Result>(write: () => Promise<Result>): Promise<Result> {
  if ('FileReader' in globalThis) return write();
  Object.assign(globalThis, { FileReader: BlobReader });
  try {
    return await write();
  } finally {
    Reflect.deleteProperty(globalThis, 'FileReader');
  }
}

function plainMaterial(material: MeshPhongMaterial, pictures: GltfPictureWriter): MeshStandardMaterial {
  const { name, color, opacity, transparent, alphaTest, side, vertexColors, map } = material;
  const plain = new MeshStandardMaterial({ name, opacity, transparent, alphaTest, side, vertexColors });
  if (color) plain.color.copy(color);
  if (map) pictures.use(plain, map);
  return plain;
}

/** Removes what glTF cannot hold or a drawing does not show, since the exporter would warn of it. */
function makePlain(object: Object3D): void {
  object.userData = {};
  if ('isLight' in object || 'isCamera' in object) object.visible = false;
  const { geometry } = object as Partial<Mesh>;
  if (!geometry) return;
  geometry.userData = {};
  makeSingle(geometry);
  const { skinIndex, normal } = geometry.attributes;
  if (skinIndex && !(skinIndex.array instanceof Uint16Array)) {
    geometry.setAttribute('skinIndex', new Uint16BufferAttribute(skinIndex.array, 4));
  }
  if (normal) {
    for (let i = 0; i < normal.count; i++) {
      const length = Math.hypot(normal.getX(i), normal.getY(i), normal.getZ(i));
      // All normals are recomputed if one has no direction.
      if (!(length > 0 && length < Infinity)) {
        geometry.deleteAttribute('normal');
        break;
      }
      normal.setXYZ(i, normal.getX(i) / length, normal.getY(i) / length, normal.getZ(i) / length);
    }
  }
  const { position, normal: normals } = geometry.morphAttributes;
  geometry.morphAttributes = {
    ...(position && { position }),
    ...(normals && geometry.attributes.normal && { normal: normals }),
  };
}

/** Converts a geometry's attributes to single precision, as glTF requires. */
function makeSingle({ attributes, morphAttributes }: BufferGeometry): void {
  for (const group of [attributes, ...Object.values(morphAttributes)] as Record<string, BufferAttribute>[]) {
    for (const [key, { array, itemSize, normalized }] of Object.entries(group)) {
      if (array instanceof Float64Array)
        group[key] = new BufferAttribute(Float32Array.from(array), itemSize, normalized);
    }
  }
}

/** Whether a track is complete and its target exists. */
function isPlayable(track: KeyframeTrack, root: Object3D): boolean {
  const { nodeName, propertyName, propertyIndex } = PropertyBinding.parseTrackName(track.name);
  const node = PropertyBinding.findNode(root, nodeName);
  const size = VALUES_PER_KEY[propertyName];
  if (!node || size === undefined) return false;
  if (propertyName === 'morphTargetInfluences') {
    const { morphTargetDictionary } = node as Mesh;
    if (morphTargetDictionary?.[propertyIndex] === undefined) return false;
  }
  // glTF supports only these two of the loaders' interpolations.
  if (track.getInterpolation() !== InterpolateDiscrete) track.setInterpolation(InterpolateLinear);
  const { times, values } = track;
  return (
    times.length > 0 &&
    values.length === size * times.length &&
    times.every((time, i) => Number.isFinite(time) && (i === 0 || time >= times[i - 1])) &&
    values.every(Number.isFinite)
  );
}
