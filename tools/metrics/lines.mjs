/**
 * @typedef {import('./measureLines.js').ModelLines} ModelLines
 */
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const others = join(root, '../shared/models');

/** The models: those of the metrics, of the examples, and files of other people if they lie beside the repository. */
const MODELS = ['sphere', 'torus', 'cube', 'bunny', 'dragon11k', 'dragon48k'];
const FILES = {
  fish: [join(root, 'examples/models'), 'fish.glb'],
  stillLife: [join(root, 'examples/models'), 'still-life.glb'],
  spot: [others, 'spot.obj'],
  nefertiti: [others, 'nefertiti_lowres.obj'],
  hand: [others, 'hand_lowres.obj'],
  Fox: [others, 'Fox.glb'],
  CesiumMan: [others, 'CesiumMan.glb'],
  Lantern: [others, 'Lantern.gltf', 'Lantern.bin', 'Lantern_emissive.png', 'Lantern_normal.png'],
};

/** The largest differences of vector drawings from the canvas. */
const LIMITS = { mean: 0.012, p99: 0.045, ink: 0.015 };

/** The heading of the section that describes vector drawings. */
const HEADING = '## Drawings as lines';

/**
 * Draws models in presets, all of those that are not named.
 *
 * @param only names of models and presets
 */
export async function measureAllLines(page, only = []) {
  const sources = [
    ...MODELS.map((name) => [name, name]),
    ...Object.entries(FILES)
      .filter(([, [folder, first]]) => existsSync(join(folder, first)))
      .map(([name, [folder, ...files]]) => [
        name,
        files.map((file) => ({ name: file, base64: readFileSync(join(folder, file), 'base64') })),
      ]),
  ];
  const named = sources.filter(([name]) => only.includes(name));
  const presets = only.filter((name) => !named.some(([model]) => model === name));
  /** @type {Record<string, ModelLines>} */
  const lines = {};
  for (const [name, source] of named.length > 0 ? named : sources) {
    lines[name] = await page.evaluate(
      ([source, presets]) => window.measureLines(source, presets),
      [source, presets.length > 0 ? presets : undefined],
    );
    for (const [preset, { mean, p99, ink, worst }] of Object.entries(lines[name]))
      console.log(`${name}, ${preset}: ${mean.toFixed(4)} ${p99.toFixed(3)} ${ink.toFixed(4)} (${worst})`);
  }
  return lines;
}

/** Drawings that differ more from the canvas than allowed, one per line. @param {Record<string, ModelLines>} lines */
export function missedLines(lines) {
  const missed = [];
  for (const [model, presets] of Object.entries(lines)) {
    for (const [preset, { mean, p99, ink }] of Object.entries(presets)) {
      if (mean > LIMITS.mean) missed.push(`${preset} of ${model}: mean ${mean.toFixed(4)}, required ≤ ${LIMITS.mean}`);
      if (p99 > LIMITS.p99) missed.push(`${preset} of ${model}: p99 ${p99.toFixed(3)}, required ≤ ${LIMITS.p99}`);
      if (Math.abs(ink - 1) > LIMITS.ink)
        missed.push(`${preset} of ${model}: ink ${ink.toFixed(4)}, required 1 ± ${LIMITS.ink}`);
    }
  }
  return missed;
}

/** The part of the page of the docs. @param {Record<string, ModelLines>} lines */
export function describeLines(lines) {
  const presets = [...new Set(Object.values(lines).flatMap((found) => Object.keys(found)))];
  const row = (cells) => `| ${cells.join(' | ')} |`;
  const marked = (value, limit, off = value) => (off > limit ? `**${value.toFixed(3)}**` : value.toFixed(3));
  const cell = ({ mean, p99, ink }) =>
    `${marked(mean, LIMITS.mean)}, ${marked(p99, LIMITS.p99)}, ${marked(ink, LIMITS.ink, Math.abs(ink - 1))}`;
  const isWhole = Object.values(lines).every((found) => presets.every((preset) => preset in found));
  return `${HEADING}

Vector files of \`drawSVG\` beside the canvas, by the share of ink in blocks of 16 × 16 CSS pixels that have any, in pictures of 640 pixels at two
pixels to one of CSS: the mean difference, its 99th percentile, and all ink of the file as a share of that on the canvas. Each is the worst of
four drawings, in which two lights, shadows or none, and a perspective and an orthographic camera meet one another once. **Bold** is
what is more than ${LIMITS.mean}, more than ${LIMITS.p99}, or farther from 1 than ${LIMITS.ink}.${isWhole ? '' : ' What is empty was not measured.'}

${row(['', ...presets])}
${row(['---', ...presets.map(() => '--:')])}
${Object.entries(lines)
  .map(([model, found]) => row([model, ...presets.map((preset) => (found[preset] ? cell(found[preset]) : ''))]))
  .join('\n')}
`;
}

/** A page of the docs with this part written anew. It is the last. @param {string} page */
export function withLines(page, lines) {
  const at = page.indexOf(HEADING);
  return `${(at < 0 ? page : page.slice(0, at)).trimEnd()}\n\n${describeLines(lines)}`;
}
