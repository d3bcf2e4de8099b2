import { ModelError, shownName } from '../common/ModelError.js';
import {
  flag,
  indexIn,
  listOf,
  mapOf,
  oneOf,
  orNothing,
  real,
  reals,
  record,
  required,
  type Shape,
  type TypeOf,
  text,
  whole,
} from './gltfShape.js';

export const COMPONENT_BYTES = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 } as const;
export const TYPE_SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 } as const;

const GEOMETRY =
  '(KHR_draco|EXT_meshopt|KHR_meshopt)_(mesh_)?compression|KHR_mesh_quantization|EXT_mesh_gpu_instancing|KHR_node_visibility';
const READABLE = new RegExp(`^(${GEOMETRY}|(KHR|EXT)_(texture|materials|lights)_\\w+)$`);
/** Supported extensions. */
const READ = new RegExp(
  `^(${GEOMETRY}|KHR_lights_punctual|KHR_animation_pointer|(KHR|EXT)_texture_(transform|webp|avif|basisu)|KHR_materials_(emissive_strength|pbrSpecularGlossiness|transmission|variants))$`,
);
/** Extensions that do not affect a drawing: gloss, light within surfaces, and authorship. */
const NEEDLESS =
  /^(KHR_materials_(anisotropy|clearcoat|diffuse_transmission|dispersion|ior|iridescence|sheen|specular|subsurface|unlit|volume|volume_scatter)|KHR_xmp(_json_ld)?)$/;

const name = orNothing(text);
const componentType = oneOf(5120, 5121, 5122, 5123, 5125, 5126);
const viewIndex = indexIn('bufferViews');
const accessorIndex = indexIn('accessors');
const nodeIndex = indexIn('nodes');

const accessor = record({
  bufferView: viewIndex,
  byteOffset: whole,
  componentType: required(componentType),
  count: required(whole),
  type: required(oneOf('SCALAR', 'VEC2', 'VEC3', 'VEC4', 'MAT2', 'MAT3', 'MAT4')),
  normalized: flag,
  sparse: record({
    count: required(whole),
    indices: required(
      record({ bufferView: required(viewIndex), byteOffset: whole, componentType: required(componentType) }),
    ),
    values: required(record({ bufferView: required(viewIndex), byteOffset: whole })),
  }),
});

const packing = record({
  buffer: required(indexIn('buffers')),
  byteOffset: whole,
  byteLength: required(whole),
  byteStride: required(whole),
  count: required(whole),
  mode: required(oneOf('ATTRIBUTES', 'TRIANGLES', 'INDICES')),
  filter: oneOf('NONE', 'OCTAHEDRAL', 'QUATERNION', 'EXPONENTIAL', 'COLOR'),
});

const bufferView = record({
  buffer: required(indexIn('buffers')),
  byteOffset: whole,
  byteLength: required(whole),
  byteStride: whole,
  extensions: record({ EXT_meshopt_compression: packing, KHR_meshopt_compression: packing }),
});

const fallback = record({});
const buffer = record({
  uri: text,
  byteLength: whole,
  extensions: record({ EXT_meshopt_compression: fallback, KHR_meshopt_compression: fallback }),
});

const camera = orNothing(
  record({
    name,
    type: required(oneOf('perspective', 'orthographic')),
    perspective: record({ yfov: required(real), aspectRatio: real }),
    orthographic: record({ xmag: required(real), ymag: required(real) }),
  }),
);

const light = orNothing(
  record({
    name,
    type: required(oneOf('directional', 'point', 'spot')),
    color: reals(3),
    intensity: real,
    spot: orNothing(record({ outerConeAngle: real })),
  }),
);

const variant = orNothing(record({ name }));

const node = record({
  name,
  camera: orNothing(indexIn('cameras')),
  children: listOf(nodeIndex),
  mesh: indexIn('meshes'),
  skin: orNothing(indexIn('skins')),
  matrix: reals(16),
  translation: reals(3),
  rotation: reals(4),
  scale: reals(3),
  weights: orNothing(listOf(real)),
  extensions: record({
    EXT_mesh_gpu_instancing: record({ attributes: mapOf(accessorIndex) }),
    KHR_node_visibility: record({ visible: flag }),
    KHR_lights_punctual: orNothing(record({ light: required(indexIn('lights')) })),
  }),
});

const mapping = record({ material: required(indexIn('materials')), variants: required(listOf(whole)) });

const primitive = record({
  attributes: required(mapOf(accessorIndex)),
  indices: accessorIndex,
  material: orNothing(indexIn('materials')),
  mode: oneOf(0, 1, 2, 3, 4, 5, 6),
  targets: orNothing(listOf(mapOf(accessorIndex))),
  extensions: record({
    KHR_draco_mesh_compression: record({ bufferView: required(viewIndex), attributes: required(mapOf(whole)) }),
    KHR_materials_variants: orNothing(record({ mappings: required(listOf(orNothing(mapping))) })),
  }),
});

const mesh = record({
  name,
  primitives: required(listOf(primitive)),
  weights: orNothing(listOf(real)),
  extras: orNothing(record({ targetNames: orNothing(listOf(text)) })),
});

const skin = record({ joints: required(listOf(nodeIndex)), inverseBindMatrices: orNothing(accessorIndex) });

const textureUse = orNothing(
  record({
    index: required(indexIn('textures')),
    texCoord: oneOf(0, 1, 2, 3),
    /** The strength of a normal map. */
    scale: real,
    /** The strength of an occlusion map. */
    strength: real,
    extensions: record({
      KHR_texture_transform: record({
        offset: reals(2),
        rotation: real,
        scale: reals(2),
        texCoord: oneOf(0, 1, 2, 3),
      }),
    }),
  }),
);

const material = orNothing(
  record({
    name,
    alphaMode: orNothing(oneOf('OPAQUE', 'MASK', 'BLEND')),
    alphaCutoff: orNothing(real),
    doubleSided: orNothing(flag),
    pbrMetallicRoughness: orNothing(
      record({
        baseColorFactor: orNothing(reals(4)),
        baseColorTexture: textureUse,
        metallicFactor: orNothing(real),
        roughnessFactor: orNothing(real),
        metallicRoughnessTexture: textureUse,
      }),
    ),
    normalTexture: textureUse,
    occlusionTexture: textureUse,
    emissiveTexture: textureUse,
    emissiveFactor: orNothing(reals(3)),
    extensions: orNothing(
      record({
        KHR_materials_emissive_strength: record({ emissiveStrength: real }),
        KHR_materials_transmission: orNothing(record({ transmissionFactor: real, transmissionTexture: textureUse })),
        KHR_materials_pbrSpecularGlossiness: record({ diffuseFactor: reals(4), diffuseTexture: textureUse }),
      }),
    ),
  }),
);

const texture = orNothing(
  record({
    source: indexIn('images'),
    sampler: orNothing(indexIn('samplers')),
    extensions: record({
      EXT_texture_webp: record({ source: indexIn('images') }),
      EXT_texture_avif: record({ source: indexIn('images') }),
      KHR_texture_basisu: record({ source: indexIn('images') }),
    }),
  }),
);

const sampler = orNothing(record({ magFilter: whole, minFilter: whole, wrapS: whole, wrapT: whole }));
const image = orNothing(record({ name, uri: text, bufferView: viewIndex }));

const channel = record({
  sampler: required(whole),
  target: required(
    record({ node: nodeIndex, path: required(oneOf('translation', 'rotation', 'scale', 'weights', 'pointer')) }),
  ),
});
const animationSampler = record({
  input: required(accessorIndex),
  output: required(accessorIndex),
  interpolation: oneOf('LINEAR', 'STEP', 'CUBICSPLINE'),
});
/** An animation. Channels and samplers of a wrong shape become undefined, and are counted along with those of wrong values. */
const animation = orNothing(
  record({
    name,
    channels: required(listOf(orNothing(channel))),
    samplers: required(listOf(orNothing(animationSampler))),
  }),
);

const scene = record({ name, nodes: listOf(nodeIndex) });

const LISTS = {
  accessors: listOf(accessor),
  bufferViews: listOf(bufferView),
  buffers: listOf(buffer),
  scenes: listOf(scene),
  nodes: listOf(node),
  meshes: listOf(mesh),
  skins: listOf(orNothing(skin)),
  materials: listOf(material),
  textures: listOf(texture),
  images: listOf(image),
  samplers: listOf(sampler),
  animations: listOf(animation),
  cameras: orNothing(listOf(camera)),
  lights: orNothing(listOf(light)),
  variants: orNothing(listOf(variant)),
};

type Lists = { [List in keyof typeof LISTS]: TypeOf<(typeof LISTS)[List]> };

/** A glTF document in which every field has its type and every index is in range, reduced to the fields that affect the drawing. */
export interface GltfDocument extends Lists {
  /** The index of the default scene, if there is one. */
  scene: number | undefined;
}

export type GltfAccessor = TypeOf<typeof accessor>;
export type GltfBufferView = TypeOf<typeof bufferView>;
export type MeshoptPacking = TypeOf<typeof packing>;
export type GltfNode = TypeOf<typeof node>;
export type GltfMesh = TypeOf<typeof mesh>;
export type GltfPrimitive = TypeOf<typeof primitive>;
export type GltfMaterial = NonNullable<TypeOf<typeof material>>;
export type GltfTextureUse = NonNullable<TypeOf<typeof textureUse>>;
export type GltfCamera = NonNullable<TypeOf<typeof camera>>;
export type GltfLight = NonNullable<TypeOf<typeof light>>;
export type GltfSampler = NonNullable<TypeOf<typeof sampler>>;
export type GltfChannel = TypeOf<typeof channel>;
export type GltfAnimationSampler = TypeOf<typeof animationSampler>;

/**
 * Parses and checks the JSON of a glTF document.
 *
 * @returns the document; the number of optional values left out because of a wrong type (those of animations become undefined and are not
 *   counted); and the unsupported extensions in use
 * @throws ModelError that names the first indispensable value of a wrong type
 */
export function readGltfDocument(
  source: string,
  fileName: string,
): { document: GltfDocument; leftOut: number; unread: string[] } {
  let json: Record<string, unknown>;
  try {
    json = JSON.parse(source) as Record<string, unknown>;
  } catch {
    throw new ModelError(`${fileName} is damaged: its description is not valid JSON.`);
  }
  checkVersion(json, fileName);
  const lists = Object.keys(LISTS) as (keyof Lists)[];
  const extensions = (json.extensions ?? {}) as Record<string, Record<string, unknown> | null | undefined>;
  const found: Record<string, unknown> = {
    ...json,
    lights: extensions.KHR_lights_punctual?.lights,
    variants: extensions.KHR_materials_variants?.variants,
  };
  const lengths = Object.fromEntries(
    lists.map((list) => [list, Array.isArray(found[list]) ? (found[list] as unknown[]).length : 0]),
  );
  const context = { name: fileName, lengths, leftOut: [] as string[] };
  const read = <List extends keyof Lists>(list: List): Lists[List] =>
    (LISTS[list] as Shape<Lists[List]>)(found[list] ?? [], list, context);
  const document = {
    ...Object.fromEntries(lists.map((list) => [list, read(list)])),
    scene: json.scene === undefined ? undefined : orNothing(indexIn('scenes'))(json.scene, 'scene', context),
  } as GltfDocument;
  const leftOut = context.leftOut.filter((at) => !at.startsWith('animations')).length;
  return { document, leftOut, unread: unreadExtensions(json) };
}

function unreadExtensions({ extensionsUsed }: Record<string, unknown>): string[] {
  const names = Array.isArray(extensionsUsed) ? extensionsUsed.filter((one) => typeof one === 'string') : [];
  return [...new Set(names)].filter((one) => !READ.test(one) && !NEEDLESS.test(one));
}

function checkVersion(json: Record<string, unknown> | null, fileName: string): void {
  const version = (json?.asset as { version?: unknown } | undefined)?.version;
  if (typeof version !== 'string') throw new ModelError(`${fileName} is not a glTF file: it does not say its version.`);
  if (!version.startsWith('2')) {
    throw new ModelError(`${fileName} is glTF version ${version.slice(0, 20)}; this page reads version 2.`);
  }
  const { extensionsRequired } = json!;
  const unknown = Array.isArray(extensionsRequired)
    ? extensionsRequired.find((one) => typeof one === 'string' && !READABLE.test(one))
    : undefined;
  if (unknown)
    throw new ModelError(`${fileName} needs the glTF extension ${shownName(unknown)}, which this page does not read.`);
}
