import { type FuzzOutcome, fuzzPage, QUESTIONS } from '../../tools/fuzz/fuzzPage.js';
import { takeWatch, watchPage } from '../../tools/fuzz/watchPage.js';
import { expect, test } from '../browser/test.js';

test.use({ viewport: { width: 320, height: 260 }, contextOptions: { reducedMotion: 'reduce' } });

/** One damaged file of each kind; some become models, some are refused. `npm run fuzz -- --browser` drops hundreds. */
const CASES: [kind: string, seed: number][] = [
  ['glb', 16],
  ['gltf', 49],
  ['meshopt', 18],
  // Instances with morph targets.
  ['meshopt', 135],
  ['obj', 3],
  ['ply', 4],
  ['stl', 5],
  ['fbx', 7],
  ['zip', 13],
  ['usd', 10],
  ['3mf', 11],
  ['draco', 30],
  // A file with damaged packed data.
  ['draco', 254],
  ['strokes', 47],
  ['animated', 21],
  ['parts', 22],
  // The second of two links is agreed to, and none of three.
  [QUESTIONS, 18],
  [QUESTIONS, 20],
];

test('damaged files leave the page drawing, silent and on its own', { tag: '@all' }, async ({
  page,
  baseURL,
  pageProblems,
}) => {
  const elsewhere = await watchPage(page, baseURL!);
  const ended: FuzzOutcome[] = [];
  await fuzzPage(
    page,
    CASES.map(([kind, seed]) => ({ kind, seed })),
    {
      address: baseURL!,
      settings: 'occlusion=0&shadows=off&outlines=off&ground=none',
      watched: [pageProblems, elsewhere],
      onCase: (outcome) => ended.push(outcome),
    },
  );
  expect(ended.flatMap(({ kind, failures }) => failures.map((failure) => `${kind}: ${failure}`))).toEqual([]);
  expect(ended.filter(({ isBlank }) => isBlank)).toEqual([]);
  expect(ended.filter(({ outcome }) => outcome === 'good').length).toBeGreaterThan(4);
  expect(ended.filter(({ outcome }) => outcome === 'refused').length).toBeGreaterThan(2);

  // The watcher must notice these problems.
  await page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2')!;
    gl.bufferData(gl.ARRAY_BUFFER, Float32Array.of(1, Number.NaN), gl.STATIC_DRAW);
    gl.getError();
    setTimeout(() => {
      const end = performance.now() + 60;
      while (performance.now() < end);
    });
  });
  let longest = 0;
  const complaints: string[] = [];
  await expect
    .poll(async () => {
      const watched = await takeWatch(page);
      complaints.push(...watched.complaints);
      longest = Math.max(longest, watched.longest);
      return longest;
    })
    .toBeGreaterThan(50);
  expect(complaints).toEqual(['bufferData is given NaN or infinity']);
  pageProblems.splice(0);
});
