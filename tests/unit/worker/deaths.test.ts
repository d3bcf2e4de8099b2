import { BoxGeometry, type BufferGeometry, Group, Mesh } from 'three';
import { applyHatching, bakeOcclusion, HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { disposeHatchingWorkers } from '../../../src/worker/runTask.js';
import type { BakingTasks } from '../../../src/worker/tasks.js';
import { FakeWorker } from './FakeWorker.js';
import { MortalWorker } from './MortalWorker.js';

/** The behaviour of every long task of the library when its worker dies. */

let died: (keyof BakingTasks)[];
let warn: ReturnType<typeof vi.spyOn>;
beforeEach(() => {
  died = [];
  warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
});
afterEach(() => {
  disposeHatchingWorkers();
  vi.restoreAllMocks();
});

/** Makes workers of which so many die of a task, not before it was asked for so often. */
function mortal(deadly: keyof BakingTasks, deaths: number, spared = 0): () => Worker {
  let left = spared;
  const isDeadly = (task: keyof BakingTasks): boolean => {
    if (task !== deadly || died.length >= deaths || left-- > 0) return false;
    died.push(task);
    return true;
  };
  return () => FakeWorker.asWorker(new MortalWorker(isDeadly));
}

const arraysOf = ({ attributes, index }: BufferGeometry) => [
  ...Object.entries(attributes).map(([name, { array }]) => [name, array]),
  index?.array,
];
const box = () => new BoxGeometry(1, 1, 1, 3, 3, 3);

test.each([
  ['corner', 'bakeCorners', 1],
  ['corner', 'bakeCorners', 2],
  ['pull', 'bakePull', 1],
  ['indexed', 'bakeIndexed', 2],
] as const)('a geometry of layout %s is prepared as ever, though %s kills %i workers', async (layout, task, deaths) => {
  const expected = await prepareHatchingGeometry(box(), { layout, outlines: true });
  const prepared = await prepareHatchingGeometry(box(), { layout, outlines: true, createWorker: mortal(task, deaths) });
  expect(arraysOf(prepared)).toEqual(arraysOf(expected));
  expect(prepared.userData.hatching).toEqual(expected.userData.hatching);
  expect([died.length, warn.mock.calls.length]).toEqual([deaths, deaths]);
});

test.each<[string, (geometry: BufferGeometry) => void]>([
  ['marked as changed', ({ attributes }) => void Object.assign(attributes.position, { needsUpdate: true })],
  ['given other positions', (geometry) => void geometry.setAttribute('position', box().attributes.position.clone())],
  ['freed', ({ attributes }) => void Object.assign(attributes.uv, { array: null })],
])('a geometry that was %s since is not prepared with the changes: the death is told', async (_, change) => {
  const geometry = box();
  const preparing = prepareHatchingGeometry(geometry, { adjacency: true, createWorker: mortal('bakeCorners', 1) });
  change(geometry);
  const error = await preparing.catch((reason) => reason);
  expect(error.message).toMatch(
    /^The hatching worker died \(of bakeCorners\) before this request was finished\. Ask again/,
  );
  expect(error.cause.message).toMatch(/^prepareHatchingGeometry: the geometry was changed while it was being prepared/);
});

test.each([
  ['startOcclusion', 0],
  ['addDirections', 0],
  ['addDirections', 1],
] as const)('occlusion is as ever, though %s kills a worker, after %i that it has survived', async (task, spared) => {
  const scenes = await Promise.all(
    [0, 1].map(async () => {
      const mesh = new Mesh(await prepareHatchingGeometry(box(), { adjacency: true }), new HatchingMaterial());
      const roof = new Mesh(box());
      roof.position.y = 1.05;
      return { mesh, scene: new Group().add(mesh, roof) };
    }),
  );
  await bakeOcclusion(scenes[0].scene, { directions: 128 });
  const passes: number[] = [];
  const createWorker = mortal(task, 1, spared);
  await bakeOcclusion(scenes[1].scene, {
    directions: 128,
    createWorker,
    onPass: ({ directions }) => passes.push(directions),
  });
  expect(died).toEqual([task]);
  expect(passes).toEqual([64, 128]);
  const [expected, given] = scenes.map(({ mesh }) => mesh.geometry.attributes.hatchNormal.array);
  expect(given).toEqual(expected);
  expect(expected.some((value, i) => i % 4 === 3 && value < 0)).toBe(true);
});

test.each([
  ['none', Infinity],
  ['the first', 0],
  ['a later one', 10],
  ['one that puts sums together', 4],
] as const)(
  'workers that share the directions of occlusion give it as ever, also if %s dies',
  { tags: ['all'] },
  async (_, spared) => {
    const bakeOf = async (createWorker?: () => Worker) => {
      const mesh = new Mesh(await prepareHatchingGeometry(box(), { adjacency: true }), new HatchingMaterial());
      const roof = new Mesh(box());
      roof.position.y = 1.05;
      const progress: number[] = [];
      const onProgress = (share: number): unknown => progress.push(share);
      await bakeOcclusion(new Group().add(mesh, roof), {
        directions: 200,
        onProgress,
        ...(createWorker && { createWorker }),
      });
      expect(progress).toEqual([...new Set(progress)].sort((a, b) => a - b));
      expect(progress.at(-1)).toBe(1);
      const { hatchNormal } = mesh.geometry.attributes;
      return Array.from({ length: hatchNormal.count }, (_, i) => -hatchNormal.getW(i));
    };
    const expected = await bakeOf();
    vi.stubGlobal('navigator', { hardwareConcurrency: 3 });
    const make = mortal('addDirections', 1, spared);
    let made = 0;
    const given = await bakeOf(() => {
      made++;
      return make();
    });
    vi.unstubAllGlobals();
    expect(died).toHaveLength(spared === Infinity ? 0 : 1);
    expect(made).toBe(spared === Infinity ? 3 : 4);
    // Sums are added in another order.
    for (const [i, value] of given.entries()) expect(Math.abs(value - expected[i])).toBeLessThan(1e-4);
    expect(Math.max(...given)).toBeGreaterThan(0.5);
  },
);

test.each(['generateHatchImages', 'generateThresholds'] as const)(
  'a map is drawn as ever, though %s kills two workers',
  async (task) => {
    const options = { size: 64, tones: 4, levels: 1 };
    const map = await TonalArtMap.generate({ ...options, createWorker: mortal(task, 2) });
    const expected = await TonalArtMap.generate(options);
    expect([map.image(2, 0), map.thresholds(0)]).toEqual([expected.image(2, 0), expected.thresholds(0)]);
    expect(died).toHaveLength(2);
  },
);

test('a map is loaded as ever, though two workers die: its files are read once more', async () => {
  const pictures = (await (await TonalArtMap.generate({ size: 64, tones: 4, levels: 1 })).save()).filter(({ name }) =>
    name.startsWith('tone'),
  );
  const map = await TonalArtMap.load(pictures, { createWorker: mortal('completeHatchImages', 2) });
  const expected = await TonalArtMap.load(pictures);
  expect([map.image(2, 1), map.thresholds(1)]).toEqual([expected.image(2, 1), expected.thresholds(1)]);
  expect(died).toHaveLength(2);
});

test('a scene is hatched as ever', async () => {
  const scene = new Group().add(new Mesh(box()));
  const { skipped, materials } = await applyHatching(scene, {
    tonalArtMap: null,
    createWorker: mortal('bakeCorners', 2),
  });
  expect([skipped, materials.length]).toEqual([[], 1]);
});
