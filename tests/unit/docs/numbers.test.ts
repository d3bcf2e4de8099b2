import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { EXAMPLES } from '../../../examples/examples.js';
import { MANY_TRIANGLES } from '../../../src/material/geometry/PrepareHatchingGeometryOptions.js';
import { MAX_SEARCHED } from '../../../src/material/outlines/InstanceList.js';
import { CORNER_STRIDE, hatchNormal } from '../../../src/mesh/bake/attributeLayouts.js';
import { TRIANGLE_WORDS, VERTEX_WORDS } from '../../../src/mesh/bake/pullLayout.js';
import { presets } from '../../../src/scene/presets.js';
import { strokeStyles } from '../../../src/strokes/strokeStyles.js';
import { DOCUMENTS, root } from './documents.js';

/** Numbers that the documents repeat must be those of the benchmarks, or of the code. */

const page = (name: string): string => DOCUMENTS[name].replace(/\s+/g, ' ');

/** The numbers in the groups of a pattern, which must match a document once. */
function numbersIn(name: string, pattern: RegExp): number[] {
  const matches = [...page(name).matchAll(new RegExp(pattern, 'g'))];
  expect(matches, `${name}: ${pattern}`).toHaveLength(1);
  return matches[0].slice(1).map((text) => Number(text.replaceAll(',', '')));
}

const resultOf = (benchmark: string) =>
  JSON.parse(readFileSync(`${root}tools/bench/results/${benchmark}.json`, 'utf8')).result;

const rounded = (value: number, digits: number): number => Number(value.toFixed(digits));

test('every benchmark says what its numbers mean', () => {
  expect(DOCUMENTS['docs/research/benchmarks.md']).not.toMatch(/\b(undefined|NaN|null)\b/);
});

const WORDS = [
  'zero',
  'one',
  'two',
  'three',
  'four',
  'five',
  'six',
  'seven',
  'eight',
  'nine',
  'ten',
  'eleven',
  'twelve',
];
WORDS.push(
  'thirteen',
  'fourteen',
  'fifteen',
  'sixteen',
  'seventeen',
  'eighteen',
  'nineteen',
  'twenty',
  'twenty-one',
  'twenty-two',
);

describe('times are those of the benchmarks', () => {
  type Frame = { drawn: Record<string, { to: Record<string, number[]> }> };
  const frames = (rasteriser: string): Record<string, Frame> => resultOf(`frame.${rasteriser}`).models;
  const ratio = (model: string, drawn: string, to: string, rasteriser = 'gpu'): number =>
    frames(rasteriser)[model].drawn[drawn].to[to][0];

  test.each([
    ['48', 'dragon48k'],
    ['871', 'dragon871k'],
  ])('of techniques, %s k triangles', (thousands, model) => {
    const cell = '([\\d.]+)';
    const row = new RegExp(
      `\\| time of a frame, ${thousands} k triangles \\| ${cell} \\| ${cell} \\| ${cell} \\| ${cell} \\|`,
    );
    const measured = ['triangle corner', 'adjacency corner', 'hatching indexed', 'engraving indexed'].map((drawn) =>
      rounded(ratio(model, drawn, 'phong indexed'), 1),
    );
    expect(numbersIn('docs/presets.md', row)).toEqual(measured);
  });

  test.each(['11', '48', '202', '871'])('of anchored strokes beside adjacency, %s k triangles', (thousands) => {
    const measured = ['gpu', 'swiftshader', 'llvmpipe'].map((rasteriser) =>
      rounded(ratio(`dragon${thousands}k`, 'hatching indexed', 'adjacency corner', rasteriser), 2),
    );
    const row = new RegExp(`\\| ${thousands} k triangles \\| ([\\d.]+) \\| ([\\d.]+) \\| ([\\d.]+) \\|`);
    expect(numbersIn('docs/research/methods.md', row)).toEqual(measured);
  });

  test('of a frame, a map and a bake', () => {
    const [least, most] = numbersIn('docs/performance.md', /([\d.]+) to ([\d.]+) times Phong shading/);
    for (const model of Object.keys(frames('gpu'))) {
      for (const drawn of ['hatching indexed', 'engraving indexed']) {
        expect(ratio(model, drawn, 'phong indexed')).toBeGreaterThan(least - 0.05);
        expect(ratio(model, drawn, 'phong indexed')).toBeLessThan(most);
      }
    }
    const maps = Object.entries<{ cold: number }>(resultOf('tam').maps).filter(([name]) => name.endsWith(' 256'));
    const seconds = maps.map(([, { cold }]) => cold / 1000);
    const range = [Math.min(...seconds), Math.max(...seconds)].map((time) => rounded(time, 1));
    expect(numbersIn('docs/performance.md', /once per style \| ([\d.]+) to ([\d.]+) s/)).toEqual(range);
    const bakes = ['dragon48k', 'dragon871k'].map((model) => {
      const {
        transfer: _transfer,
        'pack pull': _pull,
        'pack indexed': _indexed,
        ...steps
      } = resultOf('bake').models[model].warm;
      return rounded(Object.values<number>(steps).reduce((sum, time) => sum + time, 0) / 1000, 1);
    });
    const text = /once per geometry \| ([\d.]+) s for 48,000 triangles, ([\d.]+) s for 871,000/;
    expect(numbersIn('docs/performance.md', text)).toEqual(bakes);
  });

  test('of the layout pull, shadows across strokes, and lists of lines', () => {
    expect(page('docs/performance.md')).toContain('about three quarters of the time');
    for (const model of ['dragon202k', 'torus500k', 'dragon871k']) {
      expect(ratio(model, 'adjacency pull', 'adjacency corner')).toBeCloseTo(0.75, 1);
    }
    expect(page('docs/presets.md')).toContain('adds about a fifth to a frame of `hatching`');
    const shadows = Object.values<{ drawn: Record<string, { ratio: number[] }> }>(resultOf('shadows.gpu').models);
    for (const { drawn } of shadows) expect(drawn['hatching cross'].ratio[0]).toBeCloseTo(1.2, 1);
    const lists = Object.values<{ listed: number; primitives: number }>(resultOf('lines.gpu').models);
    const shares = lists.map(({ listed, primitives }) => Math.round((100 * listed) / primitives));
    const text = /(\d+) to (\d+) % of them are drawn/;
    expect(numbersIn('docs/outlines.md', text)).toEqual([Math.min(...shares), Math.max(...shares)]);
  });

  test('of instructions that a fragment executes', () => {
    type Counts = Record<'intel' | 'amd', { executed: number }>;
    const path = `${root}tools/instructions/results.json`;
    const { cases }: { cases: Record<string, Counts> } = JSON.parse(readFileSync(path, 'utf8'));
    const span = (look: string) =>
      (['amd', 'intel'] as const)
        .map((chip) => cases[look][chip].executed / cases.phong[chip].executed)
        .sort((a, b) => a - b)
        .map(Math.round);
    expect(
      numbersIn('README.md', /(\d+) to (\d+) times the instructions of Phong in .*?, (\d+) to (\d+) in `pen`/),
    ).toEqual([...span('engraving'), ...span('pen')]);
    expect(
      numbersIn('docs/performance.md', /(\d+) to (\d+) times the instructions of Phong in .*?, (\d+) to (\d+) times/),
    ).toEqual([...span('engraving'), ...span('default')]);
  });

  test('of script by mesh, with lines from mesh to mesh and with outlines', () => {
    const scenes = ['gpu', 'swiftshader', 'llvmpipe'].map(
      (rasteriser): Record<string, { microseconds: number }> => resultOf(`many.${rasteriser}`).scenes['1,000 meshes'],
    );
    const span = (times: readonly number[]) => [Math.min(...times), Math.max(...times)].map((time) => rounded(time, 1));
    const alone = scenes.flatMap((looks) =>
      ['hatching', 'engraving', 'pen', 'pencil'].map((look) => looks[look].microseconds),
    );
    const joined = scenes.map((looks) => looks['engraving, lines from mesh to mesh'].microseconds);
    const outlined = scenes.map((looks) => looks['pen, with outlines'].microseconds - looks.pen.microseconds);
    const text =
      /each takes ([\d.]+) to ([\d.]+) microseconds of script .* own work, ([\d.]+) to ([\d.]+) where .* mesh, and ([\d.]+) to ([\d.]+) more with outlines/;
    expect(numbersIn('docs/performance.md', text)).toEqual([alone, joined, outlined].flatMap(span));
  });

  test('of pixels that flip while the light turns', () => {
    const flips = /Flips under a 0\.5° turn of the light.*?\|.*?\| ([\d.]+) \(\w+\) \| ([\d.]+) \(\w+\)/;
    const [anchored, engraved] = numbersIn('docs/research/metrics.md', flips);
    expect(numbersIn('docs/research/methods.md', /worst case is ([\d.]+) times the flips/)).toEqual([anchored]);
    expect(numbersIn('docs/engraving.md', /up to ([\d.]+) times as many pixels change/)).toEqual([
      rounded(engraved, 1),
    ]);
  });

  test('of techniques beside hatching', () => {
    const ratios = (rasteriser: string, technique: string): number[] =>
      Object.values<{ drawn: Record<string, { ratio: number[] }> }>(resultOf(`media.${rasteriser}`).models)
        .map(({ drawn }) => rounded(drawn[technique].ratio[0], 1))
        .sort();
    const [dry] = numbersIn('docs/media.md', /Under SwiftShader a frame of `dryMedia` takes ([\d.]+) times/);
    expect(ratios('swiftshader', 'dryMedia')).toEqual([dry, dry]);
    const lines = numbersIn('docs/media.md', /one of `engraving` or `woodcut` ([\d.]+) to ([\d.]+) times/);
    const measured = [...ratios('swiftshader', 'engraving'), ...ratios('swiftshader', 'woodcut')];
    expect(lines).toEqual([Math.min(...measured), Math.max(...measured)]);
    const stipple = numbersIn('docs/media.md', /stippling takes ([\d.]+) to ([\d.]+) times/);
    expect(stipple).toEqual(ratios('llvmpipe', 'stipple'));
  });
});

describe('counts are those of the code', () => {
  test('set-ups of features and techniques', () => {
    const [features, techniques, setUps] = numbersIn(
      'docs/support.md',
      /(\d+) features with (\d+) techniques: (\d+) set-ups/,
    );
    expect(features * techniques).toBe(setUps);
    expect(numbersIn('README.md', /measured in (\d+) set-ups/)).toEqual([setUps]);
  });

  test('examples, styles and presets', () => {
    expect(page('README.md')).toContain(`\`examples\` has ${WORDS[EXAMPLES.length]} small pages`);
    const styles = Object.keys(strokeStyles);
    expect(page('docs/maps.md')).toContain(
      `one of ${WORDS[styles.length]} styles: ${styles.map((name) => `\`'${name}'\``).join(', ')}`,
    );
    const names = Object.keys(presets);
    expect(page('README.md')).toContain(names.map((name) => `\`${name}\``).join(', '));
    for (const [name, text] of [
      ['README.md', `A hand in ${WORDS[names.length]} presets`],
      ['docs/presets.md', `A hand in ${WORDS[names.length]} presets`],
      ['docs/first-picture.md', `shows all ${WORDS[names.length]}`],
      ['CHANGELOG.md', `\`presets\`: ${WORDS[names.length]} looks`],
    ]) {
      expect(page(name)).toContain(text);
    }
  });

  test('presets and their techniques', () => {
    const named: Record<string, string[]> = {};
    for (const [name, { material }] of Object.entries(presets)) {
      named[material.technique!] = [...(named[material.technique!] ?? []), `\`${name}\``];
    }
    for (const [technique, names] of Object.entries(named)) {
      const list = [names.slice(0, -1).join(', '), names.at(-1)].filter(Boolean).join(' and ');
      const sentence = `${list} ${names.length > 1 ? 'draw' : 'draws'} with \`${technique}\``;
      expect(page('docs/presets.md').replaceAll('\n', ' ')).toContain(sentence);
    }
  });

  test('bytes of layouts', () => {
    const corner = 3 * (4 * 3 + 4 * CORNER_STRIDE + 2 * hatchNormal.itemSize);
    expect(numbersIn('docs/geometry.md', /adjacency vertices \| (\d+) \|/)).toEqual([corner]);
    expect(numbersIn('docs/geometry.md', /pre-pass writes \| (\d+), and (\d+) bytes per vertex/)).toEqual([
      4 * TRIANGLE_WORDS,
      4 * VERTEX_WORDS,
    ]);
    expect(numbersIn('docs/geometry.md', /none, but (\d+) bytes per vertex/)).toEqual([2 * hatchNormal.itemSize]);
    expect(numbersIn('docs/presets.md', /bytes per triangle \| (\d+), or (\d+) with/)).toEqual([
      corner,
      4 * TRIANGLE_WORDS,
    ]);
  });

  test('limits', () => {
    expect(numbersIn('docs/geometry.md', /morph targets or more than ([\d,]+) triangles/)).toEqual([MANY_TRIANGLES]);
    expect(numbersIn('docs/outlines.md', /at most (\d+) million primitives/)).toEqual([MAX_SEARCHED / 1e6]);
  });

  test('sizes in kB', () => {
    const spec = readFileSync(`${root}tests/consumers/consumers.spec.ts`, 'utf8');
    const limits = [
      ...['HatchingMaterial', 'TonalArtMap', 'applyHatching', 'Hatched'].map(
        (name) => new RegExp(`\\b${name}', '[-/a-z]+', ([\\d_]+)`),
      ),
      /HatchingNodeMaterial, applyHatching', ([\d_]+)/,
      /MOST_BYTES_OF_WORKER = ([\d_]+)/,
    ].map((pattern) => Number(pattern.exec(spec)?.[1].replaceAll('_', '')) / 1000);
    const told = numbersIn('README.md', new RegExp(Array(6).fill('less than (\\d+) kB').join(' .* ')));
    expect(limits.length).toBe(told.length);
    for (const [i, limit] of limits.entries()) expect(told[i]).toBeGreaterThanOrEqual(limit);
  });

  test('what the three lines load', () => {
    const spec = readFileSync(`${root}tests/consumers/loading.spec.ts`, 'utf8');
    const limits = ['AT_ONCE', 'LATER'].map(
      (name) => Number(new RegExp(`MOST_${name} = ([\\d_]+)`).exec(spec)?.[1].replaceAll('_', '')) / 1000,
    );
    expect(numbersIn('README.md', /load at most (\d+) kB at once and (\d+) kB in/)).toEqual(limits);
  });

  test('versions', () => {
    const { peerDependencies, devEngines } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'));
    const [three] = /\d+\.\d+/.exec(peerDependencies.three)!;
    expect(page('README.md')).toContain(`It needs three.js ${three} or newer`);
    expect(page('CONTRIBUTING.md')).toContain(`Node ${devEngines.runtime.version.replace('>=', '')} or newer`);
  });
});
