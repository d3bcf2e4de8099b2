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
import { applyHatching, bakeOcclusion, HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { afterAll, describe, expect, test } from 'vitest';
import type { Random } from '../../../../src/demo/settings/Random.js';
import { HATCHING_PROPERTIES } from '../../../../src/material/facts/hatchingProperties.js';
import { mutateBytes, mutateText, NASTY } from '../../../../tools/fuzz/mutate.js';
import { consoleDuring, FUZZ_TIMEOUT, type FuzzReport, runCases, seedsOf, writeReport } from './report.js';

const report: FuzzReport = {};

/** What JavaScript and three.js say of their own accord. */
const INTERNALS =
  /Cannot |call stack|Class constructor|not a function|not iterable|not defined|Invalid (array|typed)|bounds|offset is|JSON at|Unexpected/;

/** A call that worked, or was refused with an error that names the function. @throws Error if it was neither */
async function outcome(caller: RegExp, call: () => unknown): Promise<'good' | 'refused'> {
  try {
    await call();
    return 'good';
  } catch (error) {
    checkRefusal(caller, error as Error);
    return 'refused';
  }
}

/** @throws the error if it does not name the function, or is not in words of ours */
function checkRefusal(caller: RegExp, error: Error): void {
  if (!caller.test(error.message) || INTERNALS.test(error.message)) throw error;
}

const checkNumbers = (what: string, values: ArrayLike<number>): void => {
  for (let i = 0; i < values.length; i++)
    if (!Number.isFinite(values[i])) throw new Error(`${what}[${i}] is ${values[i]}`);
};

const NUMBERS = [0, 1, -1, 0.5, 1e-30, 1e30, Number.NaN, Infinity, -0, 3];
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

function oddGeometry(random: Random): BufferGeometry {
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

const oddOptions = (
  random: Random,
  names: readonly string[],
  good: Readonly<Record<string, readonly unknown[]>>,
): object =>
  Object.fromEntries(
    names
      .filter(() => random.chance(0.3))
      .map((name) => [name, random.chance(0.6) ? random.pick(good[name] ?? NASTY) : random.pick(NASTY)]),
  );

const PREPARE = {
  layout: ['corner', 'pull', 'indexed', 'auto'],
  creaseAngle: [0.5, 1, 3],
  smoothingRadius: [0, 0.1, 1],
  weldTolerance: [0, 0.01],
  outlines: [true, false, { featureAngle: 1 }],
  form: [true, 'auto', { crossAngle: 1 }, { up: [0, 0, 1], front: [0, 0, 0], smoothing: 0.02, reach: 1 }],
};

async function geometryCase(random: Random): Promise<'good' | 'refused'> {
  const geometry = oddGeometry(random);
  const options = oddOptions(random, Object.keys(PREPARE), PREPARE);
  return outcome(/^prepareHatchingGeometry: /, async () => {
    const prepared = await prepareHatchingGeometry(geometry, options);
    const baked = ['hatchNormal', 'formValue', 'formSlope', 'formCrossing'];
    for (const name of ['position', 'normal', 'uv', 'color', 'skinIndex', 'skinWeight', ...baked]) {
      const attribute = prepared.attributes[name] as BufferAttribute | undefined;
      if (attribute) checkNumbers(name, drawnNumbers(prepared, attribute));
    }
  });
}

/** The numbers of the vertices that are drawn. What no triangle has is left as it was. */
function drawnNumbers({ index }: BufferGeometry, { array, itemSize }: BufferAttribute): ArrayLike<number> {
  if (!index) return array;
  return [...new Set(index.array)].flatMap((vertex) => [...array.slice(vertex * itemSize, (vertex + 1) * itemSize)]);
}

/** A few meshes below each other, perhaps in a circle. */
function oddScene(random: Random): Object3D {
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

/** What is wrong with one mesh is told by whoever prepares it. */
async function sceneCase(random: Random): Promise<'good' | 'refused'> {
  const root = oddScene(random);
  const hatched = await outcome(/^(applyHatching|prepareHatchingGeometry): /, async () => {
    const lineField = random.pick(['light', 'form', 'auto'] as const);
    const material = random.chance(0.3) ? { technique: 'engraved' as const, lineField } : undefined;
    const { skipped } = await applyHatching(root, { tonalArtMap: null, material });
    for (const { error } of skipped) if (error) checkRefusal(/^(applyHatching|prepareHatchingGeometry): /, error);
  });
  const occluded = await outcome(/^bakeOcclusion: /, async () => {
    const { meshes, skipped } = await bakeOcclusion(root, { directions: 64 });
    for (const { geometry } of meshes) checkNumbers('occlusion', geometry.attributes.hatchNormal.array);
    for (const { error } of skipped) if (error) checkRefusal(/^bakeOcclusion: /, error);
  });
  return hatched === 'good' ? occluded : hatched;
}

const MAP = {
  style: ['hatching', 'crossHatching', 'stipple'],
  seed: [1, 7],
  size: [64, 128],
  tones: [4, 5],
  levels: [1, 2],
  strokeWidth: [1, 2],
};

async function mapCase(random: Random): Promise<'good' | 'refused'> {
  // Without limits on both it would draw for minutes.
  const options = { size: 64, tones: 4, ...oddOptions(random, Object.keys(MAP), MAP) };
  if (random.chance(0.6)) {
    return outcome(/^TonalArtMap\.generate: /, async () => {
      const map = await TonalArtMap.generate(options);
      checkNumbers('thresholds', map.thresholds(0));
      checkNumbers('means', Object.values(map.thresholdMoments).flat());
    });
  }
  const images = Array.from({ length: random.pick([0, 1, 2, 3]) }, () =>
    Array.from(
      { length: random.pick([0, 1, 2]) },
      (_, level) => new Uint8Array(random.pick([4096, 4096, 3]) >> (2 * level)),
    ),
  );
  return outcome(/^TonalArtMap\.fromHatchImages: /, () => {
    const map = TonalArtMap.fromHatchImages({ images, ...options } as never);
    checkNumbers('thresholds', map.thresholds(0));
  });
}

let saved: Promise<{ name: string; bytes: Uint8Array }[]> | undefined;

async function savedMap(): Promise<{ name: string; bytes: Uint8Array }[]> {
  saved ??= TonalArtMap.generate({ size: 64, tones: 4, levels: 2 })
    .then((map) => map.save())
    .then((files) =>
      Promise.all(files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) }))),
    );
  return saved;
}

async function mapFilesCase(random: Random): Promise<'good' | 'refused'> {
  const isArtists = random.chance(0.5);
  const files = (await savedMap())
    .filter(({ name }) => !isArtists || /^tone-\d-level-0\.png$/.test(name))
    .map((file) => ({ ...file }));
  for (let i = random.below(4); i > 0; i--) {
    const file = random.pick(files);
    if (file.name.endsWith('.json') && random.chance(0.8)) {
      file.bytes = new Uint8Array(
        Buffer.from(mutateText(Buffer.from(file.bytes).toString().replaceAll(',', ',\n'), random)),
      );
    } else file.bytes = mutateBytes(file.bytes, random);
  }
  if (random.chance(0.2)) files.splice(random.below(files.length), 1);
  return outcome(/^TonalArtMap\.load: /, async () => {
    const map = await TonalArtMap.load(
      files.map(({ name, bytes }) => new File([bytes as Uint8Array<ArrayBuffer>], name)),
    );
    checkNumbers('thresholds', map.thresholds(0));
  });
}

async function materialCase(random: Random): Promise<'good' | 'refused'> {
  const names = Object.keys(HATCHING_PROPERTIES).filter(() => random.chance(0.1));
  const options = oddOptions(random, names, {});
  const { result } = await consoleDuring(() =>
    outcome(/^HatchingMaterial/, () => {
      const material = new HatchingMaterial(options as never);
      material.clone().dispose();
      JSON.stringify(material.toJSON());
      material.customProgramCacheKey();
      material.dispose();
    }),
  );
  return result;
}

describe('odd calls of the library give a result of finite numbers, or an error that names the function', () => {
  // Which of nine cases are of a kind: maps take the longest.
  const kinds = [
    ['geometry', geometryCase, [0, 1, 2]],
    ['scene', sceneCase, [8]],
    ['map', mapCase, [3]],
    ['mapFiles', mapFilesCase, [4, 5]],
    ['material', materialCase, [6, 7]],
  ] as const;
  for (const [kind, run, shares] of kinds) {
    const seeds = shares.flatMap((share) => seedsOf(share, 9));
    test(
      `${kind}: ${seeds.length} cases`,
      async () => {
        const failures = await runCases(report, kind, seeds, run);
        expect(failures.slice(0, 20)).toEqual([]);
      },
      FUZZ_TIMEOUT,
    );
  }
  afterAll(() => writeReport('library', report));
});
