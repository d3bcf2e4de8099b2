import { ModelError } from '../common/ModelError.js';
import {
  COMPONENT_BYTES,
  type GltfAccessor,
  type GltfBufferView,
  type GltfDocument,
  type MeshoptPacking,
  TYPE_SIZES,
} from './gltfDocument.js';

/** The unpacked size that is always allowed for accessors, in bytes. Larger files may use four times their own size. */
const SPARE_BYTES = 256 * 1024 * 1024;

type ComponentType = keyof typeof COMPONENT_BYTES;

const READ: Record<ComponentType, (view: DataView, at: number) => number> = {
  5120: (view, at) => view.getInt8(at),
  5121: (view, at) => view.getUint8(at),
  5122: (view, at) => view.getInt16(at, true),
  5123: (view, at) => view.getUint16(at, true),
  5125: (view, at) => view.getUint32(at, true),
  5126: (view, at) => view.getFloat32(at, true),
};

/** The maximum of each integer type, by which normalized values are divided. */
const NORMAL: Record<ComponentType, number> = { 5120: 127, 5121: 255, 5122: 32767, 5123: 65535, 5125: 1, 5126: 1 };

const MESHOPT_BYTES_AT_MOST = 256;

/** The values of a document's accessors. */
export interface AccessorValues {
  /** The number of components per item of an accessor. */
  sizeOf(accessor: number): number;
  /** The number of items of an accessor. */
  countOf(accessor: number): number;
  /** The values as floats; normalized ones are in [-1, 1]. Read-only. @throws ModelError if data is missing */
  floatsOf(accessor: number): Float32Array;
  /** As `floatsOf`, or undefined if data is missing. */
  tryFloats(accessor: number): Float32Array | undefined;
  /** The values as integers. Read-only. @throws ModelError if data is missing or not integer */
  integersOf(accessor: number): Uint32Array;
  /** The bytes of a buffer view. @throws ModelError if data is missing */
  viewOf(view: number): Uint8Array;
}

/** The values of a document's accessors, decoded from strides, sparse storage, quantization and meshopt compression. */
export class GltfValues implements AccessorValues {
  private readonly floats = new Map<number, Float32Array>();
  private readonly integers = new Map<number, Uint32Array>();
  private readonly views = new Map<number, Uint8Array>();
  private bytesLeft: number;
  private meshopt: typeof import('three/addons/libs/meshopt_decoder.module.js').MeshoptDecoder | undefined;

  constructor(
    private readonly document: GltfDocument,
    private readonly buffers: readonly Uint8Array[],
    private readonly fileName: string,
  ) {
    this.bytesLeft = SPARE_BYTES + 4 * buffers.reduce((sum, { length }) => sum + length, 0);
  }

  /** Loads meshopt's decoder if a buffer view needs it. */
  async prepare(): Promise<void> {
    if (!this.document.bufferViews.some((view) => packingOf(view))) return;
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
    await MeshoptDecoder.ready;
    this.meshopt = MeshoptDecoder;
  }

  sizeOf(accessor: number): number {
    return TYPE_SIZES[this.document.accessors[accessor].type];
  }

  countOf(accessor: number): number {
    return this.document.accessors[accessor].count;
  }

  floatsOf(accessor: number): Float32Array {
    return remember(this.floats, accessor, () =>
      this.normalize(
        accessor,
        this.read(accessor, (length) => new Float32Array(length)),
      ),
    );
  }

  /** Divides integers by the maximum of their type, in place, if the accessor is normalized. */
  normalize(accessor: number, values: Float32Array): Float32Array {
    const { componentType, normalized } = this.document.accessors[accessor];
    const largest = NORMAL[componentType];
    if (normalized && largest > 1) {
      for (let i = 0; i < values.length; i++) values[i] = Math.max(values[i] / largest, -1);
    }
    return values;
  }

  tryFloats(accessor: number): Float32Array | undefined {
    try {
      return this.floatsOf(accessor);
    } catch (error) {
      if (error instanceof ModelError) return undefined;
      throw error;
    }
  }

  integersOf(accessor: number): Uint32Array {
    return remember(this.integers, accessor, () => {
      const { componentType } = this.document.accessors[accessor];
      if (componentType === 5126)
        throw this.damaged(`accessors[${accessor}] has fractions where only whole numbers can be`);
      return this.read(accessor, (length) => new Uint32Array(length));
    });
  }

  viewOf(index: number): Uint8Array {
    return remember(this.views, index, () => {
      const view = this.document.bufferViews[index];
      const packing = packingOf(view);
      return packing ? this.unpack(packing) : this.slice(view);
    });
  }

  private slice({ buffer, byteOffset = 0, byteLength }: GltfBufferView | MeshoptPacking): Uint8Array {
    const bytes = this.buffers[buffer];
    if (byteOffset + byteLength > bytes.length) throw this.cutShort();
    return bytes.subarray(byteOffset, byteOffset + byteLength);
  }

  private unpack(packing: MeshoptPacking): Uint8Array {
    const { count, byteStride, mode, filter } = packing;
    if (byteStride === 0 || byteStride > MESHOPT_BYTES_AT_MOST)
      throw this.damaged('one of its packed parts has no valid stride');
    this.spend(count * byteStride);
    const bytes = new Uint8Array(count * byteStride);
    try {
      this.meshopt!.decodeGltfBuffer(bytes, count, byteStride, this.slice(packing), mode, filter);
    } catch (error) {
      throw error instanceof ModelError ? error : this.damaged('one of its packed parts cannot be unpacked');
    }
    return bytes;
  }

  private read<Values extends Float32Array | Uint32Array>(index: number, make: (length: number) => Values): Values {
    const accessor = this.document.accessors[index];
    const size = TYPE_SIZES[accessor.type];
    this.spend(4 * accessor.count * size);
    const values = make(accessor.count * size);
    if (accessor.bufferView !== undefined) {
      const { byteStride } = this.document.bufferViews[accessor.bufferView];
      this.copy(this.viewOf(accessor.bufferView), accessor, accessor.count, size, byteStride, (i, value) => {
        values[i] = value;
      });
    }
    if (accessor.sparse) this.applySparse(accessor, accessor.sparse, values, size);
    return values;
  }

  private applySparse(
    { componentType }: GltfAccessor,
    { count, indices, values }: NonNullable<GltfAccessor['sparse']>,
    target: Float32Array | Uint32Array,
    size: number,
  ): void {
    this.spend(4 * count);
    const places = new Uint32Array(count);
    this.copy(this.viewOf(indices.bufferView), indices, count, 1, undefined, (i, value) => {
      places[i] = value;
    });
    const { byteOffset } = values;
    this.copy(this.viewOf(values.bufferView), { byteOffset, componentType }, count, size, undefined, (i, value) => {
      const item = Math.floor(i / size);
      // Typed arrays ignore an index beyond their end.
      target[places[item] * size + (i - item * size)] = value;
    });
  }

  /** Calls `put` with every number of the first items. */
  private copy(
    bytes: Uint8Array,
    { byteOffset = 0, componentType }: { byteOffset?: number | undefined; componentType: ComponentType },
    count: number,
    size: number,
    byteStride: number | undefined,
    put: (index: number, value: number) => void,
  ): void {
    const width = COMPONENT_BYTES[componentType];
    const stride = byteStride || size * width;
    if (count > 0 && byteOffset + (count - 1) * stride + size * width > bytes.length) throw this.cutShort();
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const read = READ[componentType];
    for (let item = 0, at = byteOffset; item < count; item++, at += stride) {
      for (let k = 0; k < size; k++) put(item * size + k, read(view, at + k * width));
    }
  }

  /** Counts bytes before they are allocated, and throws if they are too many: a few bytes of text could ask for gigabytes. */
  private spend(bytes: number): void {
    this.bytesLeft -= bytes;
    if (!(this.bytesLeft >= 0))
      throw new ModelError(`${this.fileName} asks for more memory than its content explains.`);
  }

  private cutShort(): ModelError {
    return new ModelError(`${this.fileName} is cut short: its buffer ends before the data it lists.`);
  }

  private damaged(what: string): ModelError {
    return new ModelError(`${this.fileName} is damaged: ${what}.`);
  }
}

const packingOf = ({ extensions }: GltfBufferView): MeshoptPacking | undefined =>
  extensions?.EXT_meshopt_compression ?? extensions?.KHR_meshopt_compression;

function remember<Value>(values: Map<number, Value>, key: number, make: () => Value): Value {
  let value = values.get(key);
  if (value === undefined) {
    value = make();
    values.set(key, value);
  }
  return value;
}

/** A written accessor, which covers a buffer view of its own. */
interface PlainAccessor {
  bufferView: number;
  componentType: number;
  count: number;
  type: string;
  min?: number[];
  max?: number[];
}

type Values = Float32Array | Uint16Array | Uint32Array;

const TYPES: Record<number, string> = { 1: 'SCALAR', 2: 'VEC2', 3: 'VEC3', 4: 'VEC4', 16: 'MAT4' };

/** Collects the arrays of a new glTF document, each once. */
export class GltfWriter {
  readonly accessors: PlainAccessor[] = [];
  /** The arrays, by index of their buffer view. */
  readonly arrays: ArrayBuffer[] = [];
  private readonly written = new Map<Values, number>();

  /** @param size components per item @returns the index of the accessor */
  add(values: Values, size: number): number {
    let index = this.written.get(values);
    if (index === undefined) {
      index = this.accessors.length;
      this.written.set(values, index);
      this.arrays.push(
        (values.byteLength === values.buffer.byteLength ? values : values.slice()).buffer as ArrayBuffer,
      );
      const componentType = values instanceof Float32Array ? 5126 : values instanceof Uint32Array ? 5125 : 5123;
      const count = values.length / size;
      this.accessors.push({
        bufferView: index,
        componentType,
        count,
        type: TYPES[size],
        ...(size === 3 && boundsOf(values)),
      });
    }
    return index;
  }
}

/** The bounds of an accessor, which loaders use for culling. Those in the file may be missing or wrong. */
function boundsOf(values: Values): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < values.length; i++) {
    const axis = i % 3;
    if (values[i] < min[axis]) min[axis] = values[i];
    if (values[i] > max[axis]) max[axis] = values[i];
  }
  return { min, max };
}
