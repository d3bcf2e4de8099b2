import type { BufferGeometry } from 'three';
import { isInstanced, type VertexAttribute } from './vertexAttributes.js';

/** The arrays of normalized attributes that three.js reads. */
const NORMALIZABLE: ReadonlySet<string> = new Set([
  'Float32Array',
  'Uint32Array',
  'Uint16Array',
  'Uint8Array',
  'Uint8ClampedArray',
  'Int32Array',
  'Int16Array',
  'Int8Array',
]);

/**
 * Throws a TypeError or RangeError if the vertex data of `geometry` cannot be read. Returns the beginning of all further error
 * messages: the function and the name of the geometry.
 */
export function checkGeometry(geometry: BufferGeometry): string {
  if (!geometry?.isBufferGeometry) {
    throw new TypeError(
      `prepareHatchingGeometry: expected a THREE.BufferGeometry, got ${kindOf(geometry)}. For a mesh pass mesh.geometry.`,
    );
  }
  const label = `prepareHatchingGeometry: the geometry${geometry.name ? ` "${geometry.name}"` : ''}`;
  const { position } = geometry.attributes;
  if (!position) {
    throw new TypeError(`${label} has no attribute "position". Set one with three floats per vertex.`);
  }
  for (const [name, attribute] of [...Object.entries(geometry.attributes), ...morphTargets(geometry)]) {
    if (!attribute.array) {
      throw new TypeError(
        `${label}: the data of attribute "${name}" is not in memory (a GLBufferAttribute, or freed after upload). Pass a geometry whose arrays are still there.`,
      );
    }
    checkMemory(label, `attribute "${name}"`, attribute);
    if (attribute.normalized && !NORMALIZABLE.has(attribute.array.constructor.name)) {
      throw new TypeError(
        `${label}: attribute "${name}" is normalized, but a ${attribute.array.constructor.name}, which three.js cannot normalize. Set normalized to false, or use another array.`,
      );
    }
    if (!isInstanced(attribute) && attribute.count < position.count) {
      throw new RangeError(
        `${label}: attribute "${name}" has ${attribute.count} entries, but there are ${position.count} positions. Give each vertex one entry, or delete the attribute.`,
      );
    }
  }
  if (geometry.index) checkMemory(label, 'the index', geometry.index);
  return label;
}

/** Throws a TypeError if the array is shorter than the entries: a buffer that was transferred has length 0. */
function checkMemory(label: string, what: string, attribute: VertexAttribute): void {
  const values =
    'data' in attribute ? attribute.data.count * attribute.data.stride : attribute.count * attribute.itemSize;
  if (attribute.array.length >= values) return;
  throw new TypeError(
    `${label}: the data of ${what} is gone: ${attribute.array.length} values for ${attribute.count} entries. Its buffer was transferred to a worker, say; pass a geometry whose arrays are still there.`,
  );
}

const morphTargets = ({ morphAttributes }: BufferGeometry) =>
  Object.entries(morphAttributes).flatMap(([name, targets]) =>
    (targets ?? []).map((target, i) => [`${name}, morph target ${i}`, target] as const),
  );

function kindOf(value: unknown): string {
  if (value === null || typeof value !== 'object') return String(value);
  return (value as { type?: string }).type ?? value.constructor?.name ?? 'an object';
}
