import { gzipSync } from 'node:zlib';
import { MeshoptEncoder } from 'meshoptimizer';
import { PNG } from 'pngjs';
import { describeBundle } from '../../src/viewer/files/bundle.js';
import type { Random } from '../../src/viewer/settings/Random.js';
import { encodeDraco } from '../modelFiles/encodeDraco.js';
import { addTrack, GltfBuilder } from '../modelFiles/GltfBuilder.js';
import { type PlyFormat, ply } from '../modelFiles/modelWriters.js';
import { dae, fbx, tds, threeMf, usda, wrl, zip } from '../modelFiles/sceneWriters.js';

/** A file before it is damaged: text, bytes, or a glTF document with its data. */
export type GoodFile =
  | { name: string; kind: 'text'; text: string }
  | { name: string; kind: 'bytes'; bytes: Uint8Array }
  | { name: string; kind: 'gltf'; builder: GltfBuilder; isBinary: boolean };

/** Files that are dropped together. */
export type GoodDrop = GoodFile[];

interface Surface {
  positions: number[];
  normals: number[];
  uvs: number[];
  indices: number[];
}

/** A sphere of a few rings, with every attribute that vertices can have. */
function sphere(random: Random): Surface {
  const rings = 2 + random.below(4);
  const segments = 3 + random.below(5);
  const surface: Surface = { positions: [], normals: [], uvs: [], indices: [] };
  for (let i = 0; i <= rings; i++) {
    for (let j = 0; j <= segments; j++) {
      const [u, v] = [j / segments, i / rings];
      const [phi, theta] = [2 * Math.PI * u, Math.PI * v];
      const normal = [Math.sin(theta) * Math.cos(phi), Math.cos(theta), Math.sin(theta) * Math.sin(phi)];
      surface.positions.push(...normal);
      surface.normals.push(...normal);
      surface.uvs.push(u, v);
      if (i === rings || j === segments) continue;
      const a = i * (segments + 1) + j;
      const b = a + segments + 1;
      surface.indices.push(a, a + 1, b, a + 1, b + 1, b);
    }
  }
  return surface;
}

export const png = (random: Random, width = 4, height = width): Uint8Array => {
  const picture = new PNG({ width, height });
  for (let i = 0; i < picture.data.length; i++) picture.data[i] = i % 4 === 3 ? 255 : random.below(256);
  return new Uint8Array(PNG.sync.write(picture));
};

function gltfBuilder(random: Random): GltfBuilder {
  const builder = new GltfBuilder();
  const { json } = builder;
  const { positions, normals, uvs, indices } = sphere(random);
  const count = positions.length / 3;
  const attributes: Record<string, number> = { POSITION: builder.accessor(Float32Array.from(positions), 'VEC3') };
  if (random.chance(0.7)) attributes.NORMAL = builder.accessor(Float32Array.from(normals), 'VEC3');
  if (random.chance(0.7)) attributes.TEXCOORD_0 = builder.accessor(Float32Array.from(uvs), 'VEC2');
  if (random.chance(0.3)) {
    const colors = Uint8Array.from({ length: 4 * count }, () => random.below(256));
    attributes.COLOR_0 = builder.accessor(colors, 'VEC4', { normalized: true });
  }
  const primitive: Record<string, unknown> = { attributes };
  if (random.chance(0.8)) primitive.indices = builder.accessor(Uint16Array.from(indices), 'SCALAR');
  if (random.chance(0.2)) primitive.mode = random.pick([4, 5, 6]);
  json.meshes[0] = { name: 'ball', primitives: [primitive] };
  json.nodes = [{ mesh: 0, name: 'root' }];
  if (random.chance(0.4)) {
    const shapes = 1 + random.below(3);
    primitive.targets = Array.from({ length: shapes }, () => ({
      POSITION: builder.accessor(
        Float32Array.from(positions, (value) => value * random.next()),
        'VEC3',
      ),
    }));
    json.meshes[0].weights = new Array(shapes).fill(0.5);
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'weights', times, builder.accessor(new Float32Array(2 * shapes).fill(0.3), 'SCALAR'));
  }
  if (random.chance(0.4)) {
    const times = builder.accessor(Float32Array.of(0, 0.5, 1), 'SCALAR');
    addTrack(builder, 'rotation', times, builder.accessor(Float32Array.of(0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1), 'VEC4'));
    addTrack(
      builder,
      random.pick(['translation', 'scale']),
      times,
      builder.accessor(new Float32Array(27).fill(1), 'VEC3'),
      'CUBICSPLINE',
    );
  }
  const placing = random.next();
  if (placing < 0.3) {
    json.nodes.push({ name: 'bone', translation: [0, 1, 0] });
    json.nodes[0].skin = 0;
    json.scenes[0].nodes.push(1);
    const identity = Float32Array.from({ length: 16 }, (_, i) => (i % 5 === 0 ? 1 : 0));
    json.skins = [{ joints: [1], inverseBindMatrices: builder.accessor(identity, 'MAT4') }];
    attributes.JOINTS_0 = builder.accessor(new Uint8Array(4 * count), 'VEC4');
    attributes.WEIGHTS_0 = builder.accessor(
      Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0)),
      'VEC4',
    );
  } else if (placing < 0.5) {
    const TRANSLATION = builder.accessor(Float32Array.of(0, 0, 0, 3, 0, 0), 'VEC3');
    json.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION } } };
    json.extensionsUsed = ['EXT_mesh_gpu_instancing'];
  }
  if (random.chance(0.5)) {
    json.images = [
      random.chance(0.5)
        ? { bufferView: builder.view(png(random)), mimeType: 'image/png' }
        : { uri: `data:image/png;base64,${Buffer.from(png(random)).toString('base64')}` },
    ];
    json.samplers = [{ wrapS: 33071, minFilter: 9987 }];
    json.textures = [{ source: 0, sampler: 0 }];
    json.materials = [
      {
        name: 'paint',
        alphaMode: random.pick(['OPAQUE', 'MASK', 'BLEND']),
        doubleSided: random.chance(0.5),
        pbrMetallicRoughness: { baseColorFactor: [1, 0.5, 0.25, 0.5], baseColorTexture: { index: 0 } },
        normalTexture: { index: 0, scale: 0.5 },
        emissiveFactor: [0, 0.5, 0],
      },
    ];
    primitive.material = 0;
  }
  if (random.chance(0.2)) {
    json.nodes.push({ children: [0], scale: [1, -1, 1] });
    json.scenes[0].nodes = json.scenes[0].nodes.filter((node: number) => node !== 0).concat(json.nodes.length - 1);
  }
  if (random.chance(0.2)) json.scenes.push({ name: 'other', nodes: [0] });
  return builder;
}

/** A sphere with two clips: one changes morph targets, one turns a node. */
function animatedBuilder(random: Random): GltfBuilder {
  const builder = gltfBuilder(random);
  const { json } = builder;
  const steps = 1 + random.below(4);
  const times = builder.accessor(
    Float32Array.from({ length: steps }, (_, i) => i / 2),
    'SCALAR',
  );
  const turns = Float32Array.from({ length: 4 * steps }, (_, i) => (i % 4 === 3 ? 1 : random.next() - 0.5));
  json.animations = [{ name: 'first', channels: [], samplers: [] }, ...(json.animations ?? [])];
  addTrack(builder, 'rotation', times, builder.accessor(turns, 'VEC4'), random.pick(['LINEAR', 'STEP']));
  return builder;
}

/** Many small parts, some of them children of others, that share a few meshes and materials. */
function partsBuilder(random: Random): GltfBuilder {
  const builder = gltfBuilder(random);
  const { json } = builder;
  const [mesh] = json.meshes;
  json.materials ??= [];
  for (let i = 0; i < 5; i++) {
    json.meshes.push({ primitives: [{ ...mesh.primitives[0], material: json.materials.length }] });
    json.materials.push({ pbrMetallicRoughness: { baseColorFactor: [random.next(), 0.5, 0.5, 1] } });
  }
  const parts = 20 + random.below(180);
  const first = json.nodes.length;
  for (let i = 0; i < parts; i++) {
    json.nodes.push({ mesh: random.below(json.meshes.length), translation: [3 * (i % 10), 3 * Math.floor(i / 10), 0] });
    const holder = i > 0 && random.chance(0.3) ? json.nodes[first + random.below(i)] : undefined;
    if (holder) holder.children = [...(holder.children ?? []), first + i];
    else json.scenes[0].nodes.push(first + i);
  }
  return builder;
}

/** Packs the first accessor with meshopt. */
function packWithMeshopt(builder: GltfBuilder): void {
  const { json } = builder;
  const view = json.bufferViews[0];
  const count = view.byteLength / 12;
  const plain = builder.bytes.subarray(view.byteOffset, view.byteOffset + view.byteLength);
  const packed = MeshoptEncoder.encodeGltfBuffer(plain, count, 12, 'ATTRIBUTES');
  const { byteOffset, byteLength } = json.bufferViews[builder.view(packed)];
  view.extensions = {
    EXT_meshopt_compression: { buffer: 0, byteOffset, byteLength, byteStride: 12, count, mode: 'ATTRIBUTES' },
  };
  json.extensionsUsed = [...(json.extensionsUsed ?? []), 'EXT_meshopt_compression'];
}

/** A sphere, packed with Draco. */
async function dracoFile(random: Random): Promise<GoodDrop> {
  const { positions, normals, uvs, indices } = sphere(random);
  const surface = {
    NORMAL: { values: Float32Array.from(normals), size: 3 },
    POSITION: { values: Float32Array.from(positions), size: 3 },
    TEXCOORD_0: { values: Float32Array.from(uvs), size: 2 },
  };
  const { bytes: packed, ids } = await encodeDraco(surface, indices);
  const builder = new GltfBuilder();
  const { json } = builder;
  const attributes: Record<string, number> = {};
  for (const [name, { values, size }] of Object.entries(surface)) {
    attributes[name] = json.accessors.length;
    json.accessors.push({ componentType: 5126, type: `VEC${size}`, count: values.length / size });
  }
  json.accessors.push({ componentType: 5123, type: 'SCALAR', count: indices.length });
  const packing = { bufferView: builder.view(packed), attributes: ids };
  json.meshes[0].primitives[0] = {
    attributes,
    indices: json.accessors.length - 1,
    extensions: { KHR_draco_mesh_compression: packing },
  };
  json.extensionsRequired = json.extensionsUsed = ['KHR_draco_mesh_compression'];
  return [{ name: 'ball.glb', kind: 'gltf', builder, isBinary: true }];
}

/** Hatch images, from light to dark. */
const strokes = (random: Random): GoodDrop =>
  [0.2, 0.5, 0.8].map((share, i) => {
    const picture = new PNG({ width: 32, height: 32 });
    for (let p = 0; p < 4 * 32 * 32; p += 4) picture.data.set(random.chance(share) ? [0, 0, 0, 255] : WHITE, p);
    return { name: `tone-${i}.png`, kind: 'bytes', bytes: new Uint8Array(PNG.sync.write(picture)) };
  });

const WHITE = [255, 255, 255, 255];

const obj = (random: Random): GoodDrop => {
  const { positions, normals, uvs, indices } = sphere(random);
  const rows = (word: string, values: number[], size: number): string[] =>
    Array.from(
      { length: values.length / size },
      (_, i) => `${word} ${values.slice(size * i, size * (i + 1)).join(' ')}`,
    );
  const form = random.pick([(i: number) => `${i}`, (i: number) => `${i}/${i}/${i}`, (i: number) => `${i}//${i}`]);
  const faces = Array.from({ length: indices.length / 3 }, (_, t) => {
    const corners = indices.slice(3 * t, 3 * t + 3).map((i) => form(i + 1));
    return `${t % 5 === 0 ? `usemtl ${random.pick(['red', 'wood'])}\n` : ''}f ${corners.join(' ')}`;
  });
  return [
    {
      name: 'ball.obj',
      kind: 'text',
      text: [
        'mtllib ball.mtl',
        'o ball',
        ...rows('v', positions, 3),
        ...rows('vn', normals, 3),
        ...rows('vt', uvs, 2),
        'g one',
        's 1',
        ...faces,
        'l 1 2',
        '',
      ].join('\n'),
    },
    {
      name: 'ball.mtl',
      kind: 'text',
      text: 'newmtl red\nKd 1 0 0\nd 0.5\nnewmtl wood\nKd 1 1 1\nmap_Kd wood.png\nmap_Bump wood.png\n',
    },
    { name: 'wood.png', kind: 'bytes', bytes: png(random) },
  ];
};

const plyFile = (random: Random): GoodDrop => {
  const { positions, indices } = sphere(random);
  const format = random.pick<PlyFormat>(['ascii', 'binary_little_endian', 'binary_big_endian']);
  const type = random.pick(['float', 'double']);
  const hasColors = random.chance(0.5);
  const bytes = ply(
    [
      {
        name: 'vertex',
        properties: ['x', 'y', 'z']
          .map((axis) => `${type} ${axis}`)
          .concat(hasColors ? ['uchar red', 'uchar green', 'uchar blue'] : []),
        rows: Array.from({ length: positions.length / 3 }, (_, i) => [
          ...positions.slice(3 * i, 3 * i + 3),
          ...(hasColors ? [i % 256, 0, 255] : []),
        ]),
      },
      {
        name: 'face',
        properties: ['list uchar int vertex_indices'],
        rows: Array.from({ length: indices.length / 3 }, (_, t) => [indices.slice(3 * t, 3 * t + 3)]),
      },
    ],
    format,
  );
  return [{ name: 'ball.ply', kind: 'bytes', bytes }];
};

const stl = (random: Random): GoodDrop => {
  const { positions, indices } = sphere(random);
  const corner = (i: number): number[] => positions.slice(3 * indices[i], 3 * indices[i] + 3);
  const count = indices.length / 3;
  if (random.chance(0.5)) {
    const facets = Array.from(
      { length: count },
      (_, t) =>
        `facet normal 0 0 0\nouter loop\n${[0, 1, 2].map((k) => `vertex ${corner(3 * t + k).join(' ')}`).join('\n')}\nendloop\nendfacet`,
    );
    return [{ name: 'ball.stl', kind: 'text', text: `solid ball\n${facets.join('\n')}\nendsolid ball\n` }];
  }
  const view = new DataView(new ArrayBuffer(84 + 50 * count));
  view.setUint32(80, count, true);
  for (let i = 0; i < indices.length; i++) {
    corner(i).forEach((value, axis) => {
      view.setFloat32(84 + 50 * Math.floor(i / 3) + 12 * (1 + (i % 3)) + 4 * axis, value, true);
    });
  }
  return [{ name: 'ball.stl', kind: 'bytes', bytes: new Uint8Array(view.buffer) }];
};

const off = (random: Random): GoodDrop => {
  const { positions, indices } = sphere(random);
  const keyword = random.pick(['OFF', 'COFF', 'NOFF', '']);
  const more = keyword === 'COFF' ? ' 255 0 0 255' : keyword === 'NOFF' ? ' 0 0 1' : '';
  const vertices = Array.from(
    { length: positions.length / 3 },
    (_, i) => positions.slice(3 * i, 3 * i + 3).join(' ') + more,
  );
  const colour = random.pick(['', ' 0.5 0.2 0', ' # a face']);
  const faces = Array.from(
    { length: indices.length / 3 },
    (_, t) => `3 ${indices.slice(3 * t, 3 * t + 3).join(' ')}${colour}`,
  );
  const counts = `${vertices.length} ${faces.length} 0`;
  return [{ name: 'ball.off', kind: 'text', text: [keyword, counts, ...vertices, ...faces, ''].join('\n') }];
};

const text = (name: string, content: string): GoodDrop => [{ name, kind: 'text', text: content }];
const bytes = (name: string, content: Uint8Array): GoodDrop => [{ name, kind: 'bytes', bytes: content }];

const WRITERS: Record<string, (random: Random) => GoodDrop> = {
  glb: (random) => [{ name: 'ball.glb', kind: 'gltf', builder: gltfBuilder(random), isBinary: true }],
  gltf: (random) => [{ name: 'ball.gltf', kind: 'gltf', builder: gltfBuilder(random), isBinary: false }],
  meshopt: (random) => {
    const builder = gltfBuilder(random);
    packWithMeshopt(builder);
    return [{ name: 'ball.glb', kind: 'gltf', builder, isBinary: true }];
  },
  animated: (random) => [{ name: 'ball.glb', kind: 'gltf', builder: animatedBuilder(random), isBinary: true }],
  parts: (random) => [{ name: 'balls.glb', kind: 'gltf', builder: partsBuilder(random), isBinary: true }],
  obj,
  ply: plyFile,
  stl,
  off,
  gz: (random) => {
    const [file] = random.pick([plyFile, stl, obj])(random);
    const content =
      file.kind === 'text' ? Buffer.from(file.text) : file.kind === 'bytes' ? file.bytes : Buffer.alloc(0);
    return [{ name: `${file.name}.gz`, kind: 'bytes', bytes: new Uint8Array(gzipSync(content)) }];
  },
  fbx: (random) => text('box.fbx', fbx(7300, random.chance(0.5))),
  dae: (random) => text('box.dae', dae(random.chance(0.5) ? 'wood.png' : undefined, random.chance(0.3))),
  wrl: () => text('box.wrl', wrl()),
  usd: (random) =>
    random.chance(0.5) ? text('box.usda', usda()) : bytes('box.usdz', zip({ 'box.usda': usda('wood.png') }, 0)),
  '3mf': (random) => bytes('box.3mf', threeMf(random.chance(0.5) ? 0 : 9)),
  '3ds': () => bytes('box.3ds', tds()),
  zip: (random) => bytes('box.zip', zip({ 'a/box.dae': dae('wood.png'), 'a/wood.png': png(random) }, 0)),
  bundle: (random) =>
    bytes(
      'box.zip',
      zip(
        {
          'three-hatching.json': describeBundle('ink=%231d3a5f&view=x'),
          'model/box.dae': dae('wood.png'),
          'model/wood.png': png(random),
        },
        0,
      ),
    ),
};

/** Kinds that need a page: the page fetches their decoder, or asks a question. */
const PAGE_WRITERS: Record<string, (random: Random) => GoodDrop | Promise<GoodDrop>> = {
  draco: dracoFile,
  strokes,
};

export const KINDS = Object.keys(WRITERS);
export const PAGE_KINDS = [...KINDS, ...Object.keys(PAGE_WRITERS)];

/** Writes good files of a kind. */
export async function goodDrop(kind: string, random: Random): Promise<GoodDrop> {
  await MeshoptEncoder.ready;
  return (WRITERS[kind] ?? PAGE_WRITERS[kind])(random);
}
