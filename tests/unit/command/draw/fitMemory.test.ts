import { expect, test } from 'vitest';
import { fitMemory, memoryHere, mostTriangles } from '../../../../src/command/draw/drawModel.js';
import { failure } from '../../../../src/command/draw/failure.js';
import type { ReadMesh } from '../../../../src/viewer/files/readModel.js';
import { scannedTorus } from '../../../../tools/bench/detail/scannedTorus.mjs';

const readOf = (mesh: object) =>
  ({
    kind: 'mesh',
    mesh: { ...scannedTorus(100), normals: null, colors: null, ...mesh },
    notes: ['a note'],
  }) as unknown as ReadMesh;

const refusal = (reading: Promise<ReadMesh>): Promise<string> =>
  reading.then(
    () => 'read',
    (error: unknown) => failure('scan.ply', error),
  );

test('a model that fits is drawn from all its triangles', async () => {
  const model = readOf({});
  expect(await fitMemory(model, 20_000, () => {})).toBe(model);
});

test('a model that does not fit is simplified, and a note says so', async () => {
  const progress: number[] = [];
  const fitted = await fitMemory(readOf({}), 8_000, (share) => progress.push(share));
  const drawn = fitted.mesh.indices!.length / 3;
  expect(drawn).toBeLessThanOrEqual(8_000);
  expect(drawn).toBeGreaterThan(6_000);
  expect(fitted.simplified!.triangles).toBe(20_000);
  const share = (100 * fitted.simplified!.error).toFixed(2);
  expect(fitted.notes).toEqual([
    'a note',
    `${drawn.toLocaleString('en')} of 20,000 triangles are drawn, for which there is memory: within ${share} % of the radius from all of them`,
  ]);
  expect(progress.length).toBeGreaterThan(0);
});

test('without meshoptimizer a sentence says how many triangles the memory is enough for, and what to install', async () => {
  expect(await refusal(fitMemory(readOf({}), 8_000, () => {}, 'meshoptimizer/nowhere'))).toBe(
    'scan.ply: It has 20,000 triangles, and the memory here is enough for 8,000. With meshoptimizer beside three-hatching it is simplified: npm install meshoptimizer.',
  );
});

test('a model with pictures is not simplified', async () => {
  expect(await refusal(fitMemory(readOf({ uvs: new Float32Array(2) }), 8_000, () => {}))).toMatch(
    /20,000 triangles.+8,000\. Models with pictures are not simplified\.$/,
  );
});

test('sixteen gigabytes are enough for almost ten million triangles, and those of this machine for some', () => {
  expect(mostTriangles(16 * 2 ** 30)).toBe(9_900_000);
  expect(mostTriangles(memoryHere())).toBeGreaterThan(0);
});
