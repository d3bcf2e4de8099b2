import { BufferAttribute, BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute, type TypedArray } from 'three';
import { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { afterAll, describe, expect, test } from 'vitest';
import { HATCHING_PROPERTIES } from '../../../src/material/hatchingProperties.js';
import type { Random } from '../../Random.js';
import { mutateBytes, mutateText, NASTY } from './mutate.js';
import { consoleDuring, FUZZ_TIMEOUT, type FuzzReport, runCases, seedsOf, writeReport } from './report.js';

const report: FuzzReport = {};

/** What JavaScript and three.js say of their own accord. */
const INTERNALS =
  /Cannot |not a function|not iterable|not defined|Invalid (array|typed)|bounds|offset is|JSON at|Unexpected/;

/** A call that worked, or was refused with an error that names the function. @throws Error if it was neither */
async function outcome(caller: RegExp, call: () => unknown): Promise<'good' | 'refused'> {
  try {
    await call();
    return 'good';
  } catch (error) {
    const { message } = error as Error;
    if (!caller.test(message) || INTERNALS.test(message)) throw error;
    return 'refused';
  }
}

const checkNumbers = (what: string, values: ArrayLike<number>): void => {
  for (let i = 0; i < values.length; i++)
    if (!Number.isFinite(values[i])) throw new Error(`${what}[${i}] is ${values[i]}`);
};

const NUMBERS = [0, 1, -1, 0.5, 1e-30, 1e30, Number.NaN, Infinity, -0, 3];
const ARRAYS = [Float32Array, Float32Array, Float32Array, Float64Array, Uint8Array, Int16Array, Uint32Array];

function oddGeometry(random: Random): BufferGeometry {
  const geometry = new BufferGeometry();
  const vertices = random.pick([0, 1, 2, 3, 4, 6, 9, 30]);
  const isWild = random.chance(0.3);
  const value = (): number => (isWild && random.chance(0.05) ? random.pick(NUMBERS) : random.next());
  const attribute = (size: number, count = vertices): BufferAttribute | InterleavedBufferAttribute => {
    const array = new (random.pick(ARRAYS))(Array.from({ length: size * count }, value)) as TypedArray;
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
  if (random.chance(0.2)) geometry.setDrawRange(random.below(9), random.pick([0, 3, 5, Infinity, -1, Number.NaN]));
  if (random.chance(0.2)) geometry.addGroup(random.below(9), random.pick([0, 3, 7, Infinity]), random.below(3));
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
  lines: [true, false, { creaseAngle: 1 }],
};

async function geometryCase(random: Random): Promise<'good' | 'refused'> {
  const geometry = oddGeometry(random);
  const options = oddOptions(random, Object.keys(PREPARE), PREPARE);
  return outcome(/^prepareHatchingGeometry: /, async () => {
    const prepared = await prepareHatchingGeometry(geometry, options);
    for (const name of ['position', 'normal', 'uv', 'color', 'hatchNormal']) {
      const { array } = (prepared.attributes[name] as BufferAttribute | undefined) ?? { array: [] };
      checkNumbers(name, array);
    }
  });
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
  // How many of eight cases are of a kind: maps take the longest.
  const kinds = [
    ['geometry', geometryCase, [0, 1, 2]],
    ['map', mapCase, [3]],
    ['mapFiles', mapFilesCase, [4, 5]],
    ['material', materialCase, [6, 7]],
  ] as const;
  for (const [kind, run, shares] of kinds) {
    const seeds = shares.flatMap((share) => seedsOf(share, 8));
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
