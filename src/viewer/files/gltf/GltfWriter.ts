/** A written accessor, which covers a buffer view of its own. */
export interface PlainAccessor {
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
