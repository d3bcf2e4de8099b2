import {
  AmbientLight,
  type Camera,
  DirectionalLight,
  OrthographicCamera,
  PerspectiveCamera,
  PointLight,
  Scene,
  SpotLight,
} from 'three';
import { applyHatching } from 'three-hatching';
import { drawSVG } from 'three-hatching/svg';
import { afterAll, expect, test } from 'vitest';
import type { Random } from '../../../../src/viewer/settings/Random.js';
import { NUMBERS, oddOptions, oddScene, outcome } from './oddThings.js';
import { FUZZ_TIMEOUT, type FuzzReport, runCases, seedsOf, writeReport } from './report.js';

const report: FuzzReport = {};

const OPTIONS = {
  kind: ['print', 'pen'],
  sheet: ['A5', [40, 60]],
  margin: [0, 5],
  penWidth: [0.3, 2],
  dpi: [48, 96],
  shadows: [true, false],
  order: ['travel', 'drawn'],
  hidden: ['none', 'dashed', 'faint'],
  animate: [true, 3],
  paper: ['white', 0x112233],
};

/** A camera that may stand inside of what it looks at, look along an axis, or have lost its place. */
function oddCamera(random: Random): Camera {
  const camera = random.chance(0.3)
    ? new OrthographicCamera(-1, random.pick([1, 1, -1]), 1, -1, 0.1, 20)
    : new PerspectiveCamera(random.pick([30, 90, 170]), random.pick([1, 0.5, 3]), random.pick([0.1, 1, 1e-6]), 20);
  const near = random.chance(0.5) ? 0.3 : 4;
  camera.position.set(...([0, 1, 2].map(() => near * (random.next() - 0.5)) as [number, number, number]));
  if (random.chance(0.05)) camera.position.x = random.pick(NUMBERS);
  camera.lookAt(0, 0, 0);
  return camera;
}

async function drawingCase(random: Random): Promise<'good' | 'refused'> {
  const root = oddScene(random);
  const scene = new Scene();
  const lights = [new AmbientLight(), new DirectionalLight(), new PointLight(), new SpotLight()];
  const light = random.pick(lights);
  light.position.set(random.pick(NUMBERS), random.pick(NUMBERS), 1);
  light.castShadow = !('isAmbientLight' in light) && random.chance(0.5);
  scene.add(light);
  const hatched = await outcome(/^(applyHatching|prepareHatchingGeometry): /, () =>
    applyHatching(root, {
      preset: random.pick(['engraving', 'banknote', 'pen', 'woodcut', 'stipple'] as const),
      layout: random.pick(['auto', 'indexed', 'corner'] as const),
    }),
  );
  if (hatched === 'refused') return 'refused';
  scene.add(root);
  // Some options that go together, and some that never do.
  const options = random.chance(0.5) ? {} : oddOptions(random, Object.keys(OPTIONS), OPTIONS);
  return outcome(/^drawSVG[:.]/, async () => {
    const { svg, leftOut, layers, files, dxf, plotSeconds, surfaceLines, ...counts } = await drawSVG(
      scene,
      oddCamera(random),
      {
        sheet: [60, 60],
        ...options,
      },
    );
    if (/NaN|Infinity|undefined/.test(svg)) throw new Error('the file holds a number that is none');
    for (const [name, count] of Object.entries(counts))
      if (!(count >= 0 && count < Infinity)) throw new Error(`${name} is ${count}`);
    for (const { reason } of leftOut) if (!/^The .*\.$/s.test(reason)) throw new Error(`no sentence: ${reason}`);
  });
}

const seeds = seedsOf(8, 9);
test(`odd scenes are drawn as lines, or refused with an error that names the function: ${seeds.length} cases`, {
  tags: ['all'],
  timeout: FUZZ_TIMEOUT,
}, async () => {
  const failures = await runCases(report, 'drawing', seeds, drawingCase);
  expect(failures.slice(0, 20)).toEqual([]);
});
afterAll(() => writeReport('drawings', report));
