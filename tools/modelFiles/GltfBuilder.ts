type Values = Float32Array | Uint8Array | Uint16Array | Uint32Array;

const COMPONENTS = new Map<unknown, number>([
  [Float32Array, 5126],
  [Uint8Array, 5121],
  [Uint16Array, 5123],
  [Uint32Array, 5125],
]);
const SIZES: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

/** A glTF document. Tests change it freely, also so that it is invalid. */
// biome-ignore lint/suspicious/noExplicitAny: tests damage it on purpose.
export type Json = any;

/** Builds glTF files. */
export class GltfBuilder {
  readonly json: Json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: {} }] }],
    accessors: [],
    bufferViews: [],
    buffers: [{}],
  };
  private readonly chunks: Uint8Array[] = [];
  private length = 0;

  view(bytes: Uint8Array): number {
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.length, byteLength: bytes.length });
    const padded = new Uint8Array(Math.ceil(bytes.length / 4) * 4);
    padded.set(bytes);
    this.chunks.push(padded);
    this.length += padded.length;
    return this.json.bufferViews.length - 1;
  }

  accessor(values: Values, type: string, more: object = {}): number {
    const bufferView = this.view(new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
    const componentType = COMPONENTS.get(values.constructor);
    this.json.accessors.push({ bufferView, componentType, type, count: values.length / SIZES[type], ...more });
    return this.json.accessors.length - 1;
  }

  get bytes(): Uint8Array {
    return new Uint8Array(Buffer.concat(this.chunks));
  }

  /** The file as GLB. @param bytes of its buffer */
  glb(bytes = this.bytes): Uint8Array {
    const [buffer] = Array.isArray(this.json.buffers) ? this.json.buffers : [];
    if (typeof buffer === 'object' && buffer) buffer.byteLength ??= bytes.length;
    const text = Buffer.from(JSON.stringify(this.json));
    const json = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
    const head = Buffer.alloc(20);
    head.write('glTF', 0, 'latin1');
    head.writeUInt32LE(2, 4);
    head.writeUInt32LE(28 + json.length + bytes.length, 8);
    head.writeUInt32LE(json.length, 12);
    head.write('JSON', 16, 'latin1');
    const between = Buffer.alloc(8);
    between.writeUInt32LE(bytes.length, 0);
    between.write('BIN\0', 4, 'latin1');
    return new Uint8Array(Buffer.concat([head, json, between, bytes]));
  }
}

/** A tetrahedron with four vertices, in a mesh and a node of its own. */
export function tetrahedron(): GltfBuilder {
  const builder = new GltfBuilder();
  const corners = Float32Array.of(1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1);
  const attributes = { POSITION: builder.accessor(corners, 'VEC3') };
  const indices = builder.accessor(Uint16Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3), 'SCALAR');
  builder.json.meshes[0].primitives[0] = { attributes, indices };
  return builder;
}

/** A track of the first animation, which is added where there is none. */
export function addTrack(
  { json }: GltfBuilder,
  path: string,
  input: number,
  output: number,
  interpolation = 'LINEAR',
): void {
  json.animations ??= [{ channels: [], samplers: [] }];
  const [{ channels, samplers }] = json.animations;
  channels.push({ sampler: samplers.length, target: { node: 0, path } });
  samplers.push({ input, output, interpolation });
}
