import type { BufferGeometry } from 'three';
import { assertGeometry, kindOf, labelOf } from '../diagnostics/assertGeometry.js';
import { isInstanced, type VertexAttribute } from './vertexAttributes.js';

/** The array types that three.js can read as normalized attributes. */
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
 * Checks that the vertex data of `geometry` can be read.
 *
 * @param caller the function that the geometry was passed to
 * @returns the beginning of all further error messages: the caller and the name of the geometry
 * @throws TypeError or RangeError that names the fault and its remedy
 */
export function checkGeometry(geometry: BufferGeometry, caller = 'prepareHatchingGeometry'): string {
  assertGeometry(geometry, caller);
  const label = labelOf(geometry, caller);
  const { position } = geometry.attributes;
  if (!position) {
    throw new TypeError(`${label} has no attribute "position". Set one with three floats per vertex.`);
  }
  for (const [name, attribute] of [...Object.entries(geometry.attributes), ...morphTargets(label, geometry)]) {
    const what = `attribute "${name}"`;
    checkMemory(label, what, attribute);
    if (attribute.normalized && !NORMALIZABLE.has(attribute.array.constructor.name)) {
      throw new TypeError(
        `${label}: ${what} is normalized, but a ${attribute.array.constructor.name}, which three.js cannot normalize. Set normalized to false, or use another array.`,
      );
    }
    if (!isInstanced(attribute) && attribute.count < position.count) {
      throw new RangeError(
        `${label}: ${what} has ${attribute.count} entries, but there are ${position.count} positions. Give each vertex one entry, or delete the attribute.`,
      );
    }
  }
  if (geometry.index) checkMemory(label, 'the index', geometry.index);
  return label;
}

/**
 * Throws a TypeError if the numbers of an attribute cannot be read: if the value is no attribute at all, if its type is unknown to
 * WebGL, if its memory was freed, or if its array is too short because its buffer was transferred.
 */
function checkMemory(label: string, what: string, attribute: VertexAttribute): void {
  const fail = (fault: string): never => {
    throw new TypeError(`${label}: ${fault}`);
  };
  if (!isAttribute(attribute)) {
    fail(`${what} is ${kindOf(attribute)}, but must be a THREE.BufferAttribute. Set one, or delete it.`);
  }
  const { array } = attribute;
  if (!array) {
    fail(
      `the data of ${what} is not in memory (a GLBufferAttribute, or freed after upload). Pass a geometry whose arrays are still there.`,
    );
  }
  if (typeof array.BYTES_PER_ELEMENT !== 'number' || /^Big/.test(array.constructor.name)) {
    fail(
      `${what} has a ${array.constructor.name}, which WebGL cannot read. Use a Float32Array, or a Uint32Array for an index.`,
    );
  }
  const { count, itemSize } = attribute;
  if (!(count >= 0 && count < Infinity && itemSize > 0)) {
    fail(`${what} has ${count} entries of ${itemSize} numbers each. Give it an itemSize of 1 to 4.`);
  }
  const values = 'data' in attribute ? attribute.data.count * attribute.data.stride : count * itemSize;
  if (array.length >= values) return;
  fail(
    `the data of ${what} is gone: ${array.length} values for ${count} entries. Its buffer may have been transferred to a worker. Pass a geometry whose arrays are still there.`,
  );
}

const isAttribute = (value: unknown): boolean =>
  typeof value === 'object' &&
  value !== null &&
  ('isBufferAttribute' in value || 'isInterleavedBufferAttribute' in value || 'isGLBufferAttribute' in value);

function morphTargets(label: string, { morphAttributes }: BufferGeometry): [string, VertexAttribute][] {
  return Object.entries(morphAttributes).flatMap(([name, targets = []]) => {
    if (!Array.isArray(targets)) {
      throw new TypeError(
        `${label}: morphAttributes.${name} is ${kindOf(targets)}, but must be a list of THREE.BufferAttribute. Set one, or delete it.`,
      );
    }
    return targets.map((target, i): [string, VertexAttribute] => [`${name}, morph target ${i}`, target]);
  });
}
