import type { Attribute, DecoderModule } from 'draco3d';
import { checkReadTriangles } from '../mesh/PlainMesh.js';

/** The typed array and Draco's name for each glTF component type. */
const TYPES = {
  5120: [Int8Array, 'DT_INT8'],
  5121: [Uint8Array, 'DT_UINT8'],
  5122: [Int16Array, 'DT_INT16'],
  5123: [Uint16Array, 'DT_UINT16'],
  5125: [Uint32Array, 'DT_UINT32'],
  5126: [Float32Array, 'DT_FLOAT32'],
} as const;

/** An attribute to decode: its Draco id, and its component type. */
export interface DracoAttribute {
  id: number;
  componentType: keyof typeof TYPES;
}

/** The number of components; 0 if the attribute is missing, or has another type. */
export interface DracoValues {
  values: Float32Array;
  size: number;
}

/** A Draco-compressed primitive. */
export interface DracoPart {
  indices: Uint32Array;
  attributes: Map<string, DracoValues>;
}

const NONE: DracoValues = { values: new Float32Array(), size: 0 };

/**
 * Decodes triangles.
 *
 * @throws ModelError if they are too many
 * @throws Error if they are damaged
 */
export function decodeDraco(
  draco: DecoderModule,
  bytes: Uint8Array,
  attributes: ReadonlyMap<string, DracoAttribute>,
): DracoPart {
  const decoder = new draco.Decoder();
  const buffer = new draco.DecoderBuffer();
  const mesh = new draco.Mesh();
  try {
    buffer.Init(new Int8Array(bytes.buffer, bytes.byteOffset, bytes.length), bytes.length);
    const status = decoder.DecodeBufferToMesh(buffer, mesh);
    if (!status.ok()) throw new Error(`Draco: ${status.error_msg()}`);
    const triangles = mesh.num_faces();
    // A primitive may be empty.
    checkReadTriangles(Math.max(1, triangles));
    const indexBytes = 12 * triangles;
    const indices = copyOut(draco, indexBytes, (at) => decoder.GetTrianglesUInt32Array(mesh, indexBytes, at));
    const valuesOf = ({ id, componentType }: DracoAttribute): DracoValues => {
      const attribute = decoder.GetAttributeByUniqueId(mesh, id) as Attribute & { ptr: number };
      if (attribute.ptr === 0) return NONE;
      const [Values, type] = TYPES[componentType];
      const size = attribute.num_components();
      const byteLength = Values.BYTES_PER_ELEMENT * size * mesh.num_points();
      const copied = copyOut(draco, byteLength, (at) =>
        decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, draco[type], byteLength, at),
      );
      return copied ? { values: new Float32Array(new Values(copied)), size } : NONE;
    };
    return {
      indices: new Uint32Array(indices ?? []),
      attributes: new Map([...attributes].map(([name, attribute]) => [name, valuesOf(attribute)])),
    };
  } finally {
    for (const made of [mesh, buffer, decoder]) draco.destroy(made);
  }
}

/**
 * Copies data out of the decoder's memory.
 *
 * @param write writes to the given address, and returns false if there was nothing to write
 * @throws Error if the decoder's memory cannot grow
 */
function copyOut(
  draco: DecoderModule,
  byteLength: number,
  write: (address: number) => unknown,
): ArrayBuffer | undefined {
  const address = draco._malloc(byteLength);
  if (address === 0) throw new Error('Draco: out of memory');
  try {
    if (write(address) === false) return undefined;
    // Reads HEAPU8 only now, since the decoder's memory may have been reallocated.
    return draco.HEAPU8.slice(address, address + byteLength).buffer as ArrayBuffer;
  } finally {
    draco._free(address);
  }
}
