import { expect, test } from '../browser/test.js';

test.beforeEach(async ({ page }) => {
  await page.goto('tests/gpu/worker.html');
  await page.waitForFunction(() => window.workerTests !== undefined);
});

test('the bunny has the same bytes from the worker, from a worker of the caller and from the main thread', async ({
  page,
}) => {
  const result = await page.evaluate(() => window.workerTests.bunny());
  expect(result.workersForWorker).toBe(1);
  expect(result.workersMade).toBe(2);
  expect(result.inWorker.statistics).toMatchObject({ layout: 'corner', degenerateTriangles: 0 });
  expect(Object.keys(result.inWorker.digest)).toEqual(expect.arrayContaining(['position', 'cornerNext', 'normal']));
  expect(result.onMainThread).toEqual(result.inWorker);
  expect(result.inOwnWorker).toEqual(result.inWorker);
});

test('the indexed bunny has the same bytes from the worker and from the main thread', async ({ page }) => {
  const { inWorker, onMainThread } = await page.evaluate(() => window.workerTests.bunnyIndexed());
  expect(inWorker.statistics).toMatchObject({ layout: 'indexed', degenerateTriangles: 0 });
  expect(Object.keys(inWorker.digest).sort()).toEqual(['hatchNormal', 'index', 'normal', 'position']);
  expect(onMainThread).toEqual(inWorker);
});

test('a seam is joined to the same bytes in the worker and on the main thread', async ({ page }) => {
  const { inWorker, onMainThread } = await page.evaluate(() => window.workerTests.capsule());
  expect(inWorker.statistics).toMatchObject({ borderEdges: 0 });
  expect(onMainThread).toEqual(inWorker);
});

test('hatch images have the same bytes from the worker and from the main thread', async ({ page }) => {
  const { inWorker, onMainThread } = await page.evaluate(() => window.workerTests.hatchImages());
  expect(inWorker).toHaveLength(15);
  expect(onMainThread).toEqual(inWorker);
});

test('a worker that dies midway rejects and leaves the geometry untouched; the next request works', async ({
  page,
}) => {
  const { before, error, after, triangles } = await page.evaluate(() => window.workerTests.death());
  expect(error).toMatch(/The hatching worker died \(.*killed by the test.*\)/);
  expect(after).toEqual(before);
  expect(triangles).toBe(180_000);
});

test('a worker that closes itself midway rejects when it has been silent for long; the next request works', async ({
  page,
}) => {
  await page.clock.install();
  await page.reload();
  await page.waitForFunction(() => window.workerTests !== undefined);
  await page.evaluate(() => window.workerTests.closing());
  await page.clock.runFor(31_000);
  const { error, triangles, workers } = await page.evaluate(() => window.workerTests.closed());
  expect(error).toMatch(/The hatching worker died \(it gave no sign of life for 30 s\).*a new worker will be started/);
  expect(triangles).toBe(12);
  expect(workers).toBe(2);
});

test('requests take turns in one worker: a small one does not wait for a large one', async ({ page }) => {
  expect(await page.evaluate(() => window.workerTests.turns())).toEqual({ order: ['box', 'torus'], workersMade: 1 });
});

test('the 300 meshes of a city are baked in several workers to the same bytes, share programs, and can be cancelled', async ({
  page,
}) => {
  expect(await page.evaluate(() => window.workerTests.city())).toEqual({
    counts: [300, '1 of 300', '300 of 300'],
    workersOfCity: 3,
    drawn: { programs: 1, calls: 300 },
    error: 'AbortError',
    isUntouched: true,
    areEqual: true,
  });
});

test('an abort stops the request, not the worker', async ({ page }) => {
  const result = await page.evaluate(() => window.workerTests.abort());
  expect(result).toEqual({ error: 'AbortError', progress: [expect.any(Number)], triangles: 12, workersMade: 1 });
});

test('an error in the worker arrives with its class and text', async ({ page }) => {
  expect(await page.evaluate(() => window.workerTests.badInput())).toMatch(
    /^true prepareHatchingGeometry: the geometry: the position of vertex 3 is \(NaN, /,
  );
});

test('where the Content-Security-Policy forbids workers, the main thread computes', async ({ page, pageProblems }) => {
  await page.evaluate(() => {
    const meta = document.createElement('meta');
    meta.httpEquiv = 'Content-Security-Policy';
    meta.content = "worker-src 'none'";
    document.head.append(meta);
  });
  const result = await page.evaluate(() => window.workerTests.abort());
  expect(result).toMatchObject({ error: 'AbortError', triangles: 12 });
  // The browser's report and our warning; nothing else.
  const expected = /Content Security Policy|three-hatching: the worker could not be started/;
  expect(pageProblems.filter((problem) => /three-hatching: the worker/.test(problem))).toHaveLength(1);
  expect(pageProblems.filter((problem) => !expected.test(problem))).toEqual([]);
  pageProblems.length = 0;
});
