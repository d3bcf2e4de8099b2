import type { AccessorValues } from './GltfValues.js';
import type { GltfNode } from './gltfDocument.js';

/** The extension for instanced meshes. */
export const INSTANCING = 'EXT_mesh_gpu_instancing';
/** The number of components of each instance attribute. */
export const INSTANCE_SIZES: Readonly<Record<string, number>> = { TRANSLATION: 3, ROTATION: 4, SCALE: 3, _COLOR_0: 3 };

/** The accessors of a node's instance attributes; empty without instances. */
export type InstanceAccessors = readonly [name: string, accessor: number][];

/** The instances of a node. */
export interface Instances {
  count: number;
  attributes: [name: string, values: Float32Array][];
  /** The number of instances left out. */
  leftOut: number;
}

/** The accessors of a node's instance attributes. */
export function instanceAccessors({ extensions }: GltfNode, values: AccessorValues): InstanceAccessors {
  return Object.entries(extensions?.[INSTANCING]?.attributes ?? {}).filter(
    ([name, accessor]) => INSTANCE_SIZES[name] === values.sizeOf(accessor),
  );
}

/** The number of instances by a node's accessors. */
export const instanceCount = (accessors: InstanceAccessors, values: AccessorValues): number =>
  Math.min(...accessors.map(([, accessor]) => values.countOf(accessor)));

/** Reads the first instances, without those with NaN values. @param total how many are read */
export function readInstances(accessors: InstanceAccessors, total: number, values: AccessorValues): Instances {
  const read = accessors.map(([name, accessor]) => ({
    name,
    size: INSTANCE_SIZES[name],
    array: values.floatsOf(accessor),
  }));
  const isBad = new Uint8Array(total);
  for (const { size, array } of read) {
    for (let i = 0; i < size * total; i++) if (!Number.isFinite(array[i])) isBad[Math.floor(i / size)] = 1;
  }
  const kept = [...isBad.keys()].filter((instance) => isBad[instance] === 0);
  const pick = (array: Float32Array, size: number): Float32Array => {
    if (kept.length === total && array.length === size * total) return array;
    const picked = new Float32Array(size * kept.length);
    for (const [to, from] of kept.entries()) picked.set(array.subarray(size * from, size * (from + 1)), size * to);
    return picked;
  };
  return {
    count: kept.length,
    attributes: read.map(({ name, size, array }) => [name, pick(array, size)]),
    leftOut: total - kept.length,
  };
}
