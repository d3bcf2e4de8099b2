import { PNG } from 'pngjs';

/** A square column that can bend and swell, made by code so that the tests need no files. */

const RINGS = 9;
const CORNERS = [
  [-0.3, -0.3],
  [0.3, -0.3],
  [0.3, 0.3],
  [-0.3, 0.3],
] as const;

type Json = Record<string, unknown>;

/** Collects the data of a glTF document in one buffer. */
class BufferBuilder {
  readonly accessors: Json[] = [];
  readonly bufferViews: Json[] = [];
  private readonly parts: Buffer[] = [];
  private length = 0;

  view(bytes: Buffer): number {
    const padded = Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4)]);
    this.bufferViews.push({ buffer: 0, byteOffset: this.length, byteLength: bytes.length });
    this.parts.push(padded);
    this.length += padded.length;
    return this.bufferViews.length - 1;
  }

  accessor(values: Float32Array | Uint16Array, type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4' | 'MAT4'): number {
    const size = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 }[type];
    const componentType = values instanceof Float32Array ? 5126 : 5123;
    const bounds = { min: [-9, -9, -9].slice(0, size), max: [9, 9, 9].slice(0, size) };
    const bufferView = this.view(Buffer.from(values.buffer, values.byteOffset, values.byteLength));
    this.accessors.push({ bufferView, componentType, count: values.length / size, type, ...(size <= 3 && bounds) });
    return this.accessors.length - 1;
  }

  get content(): Buffer {
    return Buffer.concat(this.parts);
  }
}

/** A PNG image: left half red, right half blue. */
function picture(): Buffer {
  const png = new PNG({ width: 2, height: 1 });
  png.data.set([255, 0, 0, 255, 0, 0, 255, 255]);
  return PNG.sync.write(png);
}

export interface ColumnOptions {
  /** Replaces the values of the clip `Bend`. */
  bend?: number[];
  /** Number of rings of the column. Many make it a large model. */
  rings?: number;
  /** Returns properties that replace those of the document. */
  changes?: (document: Json) => Json;
  /** Replaces the image of its texture. */
  picture?: Buffer;
  /** Leaves out the skin, the clips and the morph target. */
  still?: boolean;
}

/**
 * A GLB file of the column: textured red and blue, skinned to two bones, with the clips `Bend` (1 s) and `Turn` (2 s),
 * and the morph target `Swollen`.
 */
export function columnGlb(options: ColumnOptions = {}): Buffer {
  const { rings = RINGS } = options;
  const builder = new BufferBuilder();
  const positions: number[] = [];
  const swollen: number[] = [];
  const uvs: number[] = [];
  const joints: number[] = [];
  const weights: number[] = [];
  const indices: number[] = [];
  for (let ring = 0; ring < rings; ring++) {
    const share = ring / (rings - 1);
    for (const [x, z] of CORNERS) {
      positions.push(x, 2 * share - 1, z);
      swollen.push(1.5 * x * Math.sin(Math.PI * share), 0, 1.5 * z * Math.sin(Math.PI * share));
      uvs.push(x > 0 ? 0.9 : 0.1, 0.5);
      joints.push(0, 1, 0, 0);
      weights.push(1 - share, share, 0, 0);
    }
    for (let k = 0; ring > 0 && k < 4; k++) {
      const [a, b] = [4 * ring + k, 4 * ring + ((k + 1) % 4)];
      indices.push(a - 4, b, b - 4, a - 4, a, b);
    }
  }
  const top = 4 * rings - 4;
  indices.push(0, 1, 2, 0, 2, 3, top, top + 2, top + 1, top, top + 3, top + 2);

  const attributes: Json = {
    POSITION: builder.accessor(new Float32Array(positions), 'VEC3'),
    TEXCOORD_0: builder.accessor(new Float32Array(uvs), 'VEC2'),
    ...(!options.still && {
      JOINTS_0: builder.accessor(new Uint16Array(joints), 'VEC4'),
      WEIGHTS_0: builder.accessor(new Float32Array(weights), 'VEC4'),
    }),
  };
  const primitive = {
    attributes,
    indices: builder.accessor(new Uint16Array(indices), 'SCALAR'),
    material: 0,
    ...(!options.still && { targets: [{ POSITION: builder.accessor(new Float32Array(swollen), 'VEC3') }] }),
  };
  const inverses = new Float32Array(32);
  for (const i of [0, 5, 10, 15, 16, 21, 26, 31]) inverses[i] = 1;
  const clip = (name: string, times: number[], values: number[]): Json => ({
    name,
    samplers: [
      {
        input: builder.accessor(new Float32Array(times), 'SCALAR'),
        output: builder.accessor(new Float32Array(values), 'VEC4'),
      },
    ],
    channels: [{ sampler: 0, target: { node: 1, path: 'rotation' } }],
  });
  const [c, s] = [Math.cos(0.4), Math.sin(0.4)];
  const animated: Json = {
    nodes: [{ mesh: 0, skin: 0 }, {}, { children: [1] }],
    scenes: [{ nodes: [0, 2] }],
    skins: [{ joints: [2, 1], inverseBindMatrices: builder.accessor(inverses, 'MAT4') }],
    animations: [
      clip('Bend', [0, 0.5, 1], options.bend ?? [0, 0, 0, 1, 0, 0, s, c, 0, 0, 0, 1]),
      clip('Turn', [0, 1, 2], [0, 0, 0, 1, 0, s, 0, c, 0, 0, 0, 1]),
    ],
  };
  const image = builder.view(options.picture ?? picture());
  const binary = builder.content;
  const document: Json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    ...(!options.still && animated),
    meshes: [{ primitives: [primitive], extras: { targetNames: ['Swollen'] } }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0, sampler: 0 }],
    samplers: [{ magFilter: 9728, minFilter: 9728 }],
    images: [{ bufferView: image, mimeType: 'image/png' }],
    accessors: builder.accessors,
    bufferViews: builder.bufferViews,
    buffers: [{ byteLength: binary.length }],
  };
  return packGlb(JSON.stringify({ ...document, ...options.changes?.(document) }), binary);
}

/** Packs a document and its buffer as GLB. */
export function packGlb(json: string, binary: Buffer): Buffer {
  const text = Buffer.from(json);
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const header = Buffer.alloc(12);
  header.write('glTF');
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(12 + 8 + padded.length + 8 + binary.length, 8);
  return Buffer.concat([header, chunk('JSON', padded), chunk('BIN\0', binary)]);
}

function chunk(kind: string, content: Buffer): Buffer {
  const head = Buffer.alloc(8);
  head.writeUInt32LE(content.length, 0);
  head.write(kind, 4);
  return Buffer.concat([head, content]);
}
