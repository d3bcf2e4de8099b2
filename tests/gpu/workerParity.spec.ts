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

test('the indexed bunny has the same bytes from the worker and from the main thread', { tag: '@all' }, async ({
  page,
}) => {
  const { inWorker, onMainThread } = await page.evaluate(() => window.workerTests.bunnyIndexed());
  expect(inWorker.statistics).toMatchObject({ layout: 'indexed', degenerateTriangles: 0 });
  expect(Object.keys(inWorker.digest).sort()).toEqual(['hatchNormal', 'index', 'normal', 'position']);
  expect(onMainThread).toEqual(inWorker);
});

test('a seam is joined to the same bytes in the worker and on the main thread', { tag: '@all' }, async ({ page }) => {
  const { inWorker, onMainThread } = await page.evaluate(() => window.workerTests.capsule());
  expect(inWorker.statistics).toMatchObject({ borderEdges: 0 });
  expect(onMainThread).toEqual(inWorker);
});

test('hatch images have the same bytes from the worker and from the main thread', async ({ page }) => {
  const { inWorker, onMainThread } = await page.evaluate(() => window.workerTests.hatchImages());
  expect(inWorker).toHaveLength(15);
  expect(onMainThread).toEqual(inWorker);
});

test('strokes of a picture, and the hand learnt from them, are the same from the worker, from a worker of the caller and from the main thread', {
  tag: '@all',
}, async ({ page }) => {
  const { workers, inWorker, inOwnWorker, onMainThread, learnt, learntInWorker, learntOnMainThread } =
    await page.evaluate(() => window.workerTests.tracing());
  expect(workers).toBe(1);
  expect(inWorker).toHaveLength(10);
  expect(inOwnWorker).toEqual(inWorker);
  expect(onMainThread).toEqual(inWorker);
  expect(learntInWorker).toEqual(learnt);
  expect(learntOnMainThread).toEqual(learnt);
  const { numbers } = learnt;
  expect(Math.abs(numbers.width / 6 - 1)).toBeLessThan(0.1);
  expect(Math.abs(numbers.spacing / (30 * Math.cos(Math.atan2(60, 160))) - 1)).toBeLessThan(0.1);
});

test('the geometry has the same bytes though worker after worker dies midway, and the deaths are reported', {
  tag: '@all',
}, async ({ page, pageProblems }) => {
  const { before, after, expected, died } = await page.evaluate(() => window.workerTests.death());
  expect(after).toEqual(before);
  expect(died).toEqual(expected);
  const told = pageProblems.splice(0);
  expect(told).toHaveLength(2);
  expect(told[0]).toMatch(/the worker died \(.*killed by the test.*\)\. Its tasks start over in a new worker/);
  expect(told[1]).toMatch(/the worker died \(.*killed by the test.*\)\. Its tasks start over on the main thread/);
});

test('a worker that closes itself midway without an event is replaced at once', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  // Time stands still: no silence is waited for.
  await page.clock.install();
  await page.reload();
  await page.waitForFunction(() => window.workerTests !== undefined);
  await page.clock.pauseAt(Date.now() + 3_600_000);
  const closed = await page.evaluate(() => window.workerTests.closing());
  expect(closed).toEqual({ triangles: [180_000, 12], workers: 2 });
  const told = pageProblems.splice(0);
  expect(told).toHaveLength(1);
  expect(told[0]).toMatch(/the worker died \(it has ended\)\. Its tasks start over in a new worker/);
});

test('requests take turns in one worker: a small one does not wait for a large one', { tag: '@all' }, async ({
  page,
}) => {
  expect(await page.evaluate(() => window.workerTests.turns())).toEqual({ order: ['box', 'torus'], workersMade: 1 });
});

test('the 300 meshes of a city are baked in several workers to the same bytes, share programs, and can be cancelled', {
  tag: '@all',
}, async ({ page }) => {
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
