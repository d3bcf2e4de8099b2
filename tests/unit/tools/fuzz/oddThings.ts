import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Group,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  type TypedArray,
} from 'three';
import type { Random } from '../../../../src/viewer/settings/Random.js';
import { NASTY } from '../../../../tools/fuzz/mutate.js';

/** Geometries, scenes and options that nobody would make on purpose. */

/** What JavaScript and three.js say of their own accord. */
const INTERNALS =
  /Cannot |call stack|Class constructor|not a function|not iterable|not defined|Invalid (array|typed)|bounds|offset is|JSON at|Unexpected/;

/** A call that worked, or was refused with an error that names the function. @throws Error if it was neither */
export async function outcome(caller: RegExp, call: () => unknown): Promise<'good' | 'refused'> {
  try {
    await call();
    return 'good';
  } catch (error) {
    checkRefusal(caller, error as Error);
    return 'refused';
  }
}

/** @throws the error if it does not name the function, or is not in words of ours */
export function checkRefusal(caller: RegExp, error: Error): void {
  if (!caller.test(error.message) || INTERNALS.test(error.message)) throw error;
}

export const NUMBERS = [0, 1, -1, 0.5, 1e-30, 1e30, Number.NaN, Infinity, -0, 3];
const ARRAYS = [Float32Array, Float32Array, Float32Array, Float64Array, Uint8Array, Int16Array, Uint32Array];
/** Arrays that no attribute may have. */
const badArrays = (length: number) => [
  new BigInt64Array(length),
  new BigUint64Array(length),
  new Array(length).fill(0),
  new DataView(new ArrayBuffer(length)),
];
/** What may stand where an attribute should. */
const NO_ATTRIBUTES = [null, undefined, 0, 'position', {}, [], { array: new Float32Array(9), count: 3 }, Infinity];

export function oddGeometry(random: Random): BufferGeometry {
  const geometry = new BufferGeometry();
  const vertices = random.pick([0, 1, 2, 3, 4, 6, 9, 30]);
  const isWild = random.chance(0.3);
  const value = (): number => (isWild && random.chance(0.05) ? random.pick(NUMBERS) : random.next());
  const attribute = (size: number, count = vertices): BufferAttribute | InterleavedBufferAttribute => {
    const numbers = Array.from({ length: size * count + (random.chance(0.02) ? 1 : 0) }, value);
    if (random.chance(0.01)) {
      const array = random.pick(badArrays(numbers.length)) as never;
      return Object.assign(new BufferAttribute(new Uint8Array(), size), { array, count });
    }
    const array = new (random.pick(ARRAYS))(numbers) as TypedArray;
    if (random.chance(0.1)) return new InterleavedBufferAttribute(new InterleavedBuffer(array, size), size, 0);
    return new BufferAttribute(array, size, random.chance(0.2));
  };
  const count = (): number => (random.chance(0.05) ? Math.max(0, vertices - 1) : vertices);
  for (const [name, size] of [
    ['position', 3],
    ['normal', 3],
    ['uv', 2],
    ['color', random.pick([3, 4])],
    ['skinIndex', 4],
    ['skinWeight', 4],
    ['mine', random.pick([1, 2, 3, 4])],
  ] as const) {
    if (!random.chance(name === 'position' ? 0.97 : 0.3)) continue;
    geometry.setAttribute(name, attribute(random.chance(0.05) ? random.pick([1, 2, 4]) : size, count()));
  }
  if (random.chance(0.6)) {
    const length = random.pick([0, 3, 6, 12, 30, 31]);
    const limit = random.chance(0.1) ? vertices + 3 : Math.max(1, vertices);
    geometry.setIndex(Array.from({ length }, () => random.below(limit)));
  }
  if (random.chance(0.2)) geometry.morphAttributes.position = [attribute(3, count()) as BufferAttribute];
  if (random.chance(0.03)) Reflect.set(geometry.morphAttributes, 'position', random.pick(NO_ATTRIBUTES));
  if (random.chance(0.03)) Reflect.set(geometry.morphAttributes, 'normal', [random.pick(NO_ATTRIBUTES)]);
  if (random.chance(0.03)) {
    Reflect.set(geometry.attributes, random.pick(['position', 'uv', 'mine']), random.pick(NO_ATTRIBUTES));
  }
  if (random.chance(0.02)) Reflect.set(geometry, 'index', random.pick(NO_ATTRIBUTES));
  if (random.chance(0.2)) geometry.setDrawRange(random.below(9), random.pick([0, 3, 5, Infinity, -1, Number.NaN]));
  if (random.chance(0.2)) geometry.addGroup(random.below(9), random.pick([0, 3, 7, Infinity]), random.below(3));
  if (random.chance(0.03)) {
    Reflect.set(
      geometry,
      random.pick(['attributes', 'morphAttributes', 'drawRange', 'groups']),
      random.pick([null, 3]),
    );
  }
  return geometry;
}

export const oddOptions = (
  random: Random,
  names: readonly string[],
  good: Readonly<Record<string, readonly unknown[]>>,
): object =>
  Object.fromEntries(
    names
      .filter(() => random.chance(0.3))
      .map((name) => [name, random.chance(0.6) ? random.pick(good[name] ?? NASTY) : random.pick(NASTY)]),
  );

/** A few meshes below each other, perhaps in a circle. */
export function oddScene(random: Random): Object3D {
  const root = new Group();
  const objects: Object3D[] = [root];
  for (let i = random.below(4); i >= 0; i--) {
    const geometry = random.chance(0.5) ? oddGeometry(random) : new BoxGeometry();
    const mesh = new Mesh(undefined, new MeshBasicMaterial({ transparent: random.chance(0.2) }));
    // The constructor looks at morph targets, and knows no error of its own.
    mesh.geometry = random.chance(0.05) ? (random.pick(NO_ATTRIBUTES) as never) : geometry;
    if (random.chance(0.1)) mesh.position.setScalar(random.pick(NUMBERS));
    random.pick(objects).add(mesh);
    objects.push(mesh);
  }
  if (random.chance(0.1)) random.pick(objects).children.push(random.pick(objects));
  if (random.chance(0.05)) random.pick(objects).children.push(random.pick(NO_ATTRIBUTES) as never);
  return random.pick([root, root, ...objects]);
}
