import type { BufferAttribute, BufferGeometry } from 'three';
import { applyHatching, bakeOcclusion, HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { afterAll, describe, expect, test } from 'vitest';
import { HATCHING_PROPERTIES } from '../../../../src/look/hatchingProperties.js';
import { parametersOf } from '../../../../src/look/queries.js';
import type { Random } from '../../../../src/viewer/settings/Random.js';
import { mutateBytes, mutateText } from '../../../../tools/fuzz/mutate.js';
import { checkRefusal, oddGeometry, oddOptions, oddScene, outcome } from './oddThings.js';
import { consoleDuring, FUZZ_TIMEOUT, type FuzzReport, runCases, seedsOf, writeReport } from './report.js';

const report: FuzzReport = {};

const checkNumbers = (what: string, values: ArrayLike<number>): void => {
  for (let i = 0; i < values.length; i++)
    if (!Number.isFinite(values[i])) throw new Error(`${what}[${i}] is ${values[i]}`);
};

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

/** What is wrong with one mesh is told by whoever prepares it. */
async function sceneCase(random: Random): Promise<'good' | 'refused'> {
  const root = oddScene(random);
  const hatched = await outcome(/^(applyHatching|prepareHatchingGeometry): /, async () => {
    const direction = random.pick(['light', 'form', 'auto'] as const);
    const material = random.chance(0.3) ? { technique: 'engraving' as const, direction } : undefined;
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
  const flat = oddOptions(random, names, {});
  const options = random.chance(0.9) ? parametersOf(flat as Record<string, unknown>) : flat;
  const { result } = await consoleDuring(() =>
    outcome(/^Hatching(Material|Composition|ShadowMaterial)/, () => {
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
