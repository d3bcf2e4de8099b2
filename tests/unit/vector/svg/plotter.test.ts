import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { TorusKnotGeometry } from 'three';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { drawSVG, type SVGDrawing } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';

/** Reads the files with programs of plotters and XML parsers, where these are installed. */

const runs = (command: string): boolean => spawnSync(command, ['--version']).status === 0;
const hasVpype = runs('vpype');
const hasPython = runs('python3');
const hasGcode = hasVpype && spawnSync('vpype', ['gwrite', '--help']).status === 0;
const docs = readFileSync(new URL('../../../../docs/svg.md', import.meta.url), 'utf8').replaceAll(/^ {2}/gm, '');
if (!hasVpype)
  console.log('vpype is not installed (pip install vpype): nothing reads the files of pens as plotters do.');
if (!hasPython) console.log('python3 is not installed: no parser of XML reads the files.');

const folder = mkdtempSync(join(tmpdir(), 'hatching-'));
const drawings: Partial<Record<'travel' | 'drawn' | 'print', SVGDrawing>> = {};
const fileOf = (name: keyof typeof drawings): string => join(folder, `${name}.svg`);

beforeAll(async () => {
  const knot = await hatchedMesh(new TorusKnotGeometry(0.6, 0.22, 160, 32));
  // Only vpype needs the file in the order in which lines were found.
  for (const name of ['travel', 'print', ...(hasVpype ? (['drawn'] as const) : [])] as const) {
    const order = name === 'drawn' ? name : 'travel';
    const pen = name === 'print' ? {} : ({ kind: 'pen', penWidth: 0.2 } as const);
    // The print file is only parsed, so it may be small.
    const sheet = name === 'print' ? ([60, 50] as const) : ([210, 190] as const);
    drawings[name] = await drawSVG(sceneOf(knot), cameraAt(0.4, 0.3, 1), { ...pen, order, sheet });
    writeFileSync(fileOf(name), drawings[name].svg);
  }
});

afterAll(() => rmSync(folder, { recursive: true }));

function vpype(...args: string[]): string {
  const { status, stdout, stderr } = spawnSync('vpype', args, { encoding: 'utf8' });
  expect([status, stderr]).toEqual([0, '']);
  return stdout;
}

/** The statistics of all layers, after vpype commands. */
function totalsOf(name: keyof typeof drawings, ...commands: string[]): string {
  const told = vpype('read', fileOf(name), ...commands, 'stat');
  return told.slice(told.indexOf('Totals'));
}

/** The travel of the lifted pen in all layers, after vpype commands. */
const travelOf = (name: keyof typeof drawings, ...commands: string[]): number =>
  Number(/^ {2}Pen-up length: ([\d.]+)$/m.exec(totalsOf(name, ...commands))![1]);

test('the lifted pen goes less than 15 % of the way that it goes in the order in which lines are found', () => {
  const { paths, travelBefore, travelAfter } = drawings.travel!;
  expect(paths).toBeGreaterThan(800);
  expect(travelAfter / travelBefore).toBeLessThan(0.15);
});

describe.skipIf(!hasVpype)('vpype', () => {
  test('reads the size of the sheet, the width of the pen and the layers by their names', () => {
    const read = vpype('read', fileOf('travel'), 'proplist', '-g', 'proplist', '-l', 'all');
    const pixels = (millimetres: number) => (millimetres * 96) / 25.4;
    const [width, height] = /vp_page_size: \(tuple\) \(([\d.]+), ([\d.]+)\)/.exec(read)!.slice(1).map(Number);
    expect(width).toBeCloseTo(pixels(210), 3);
    expect(height).toBeCloseTo(pixels(190), 3);
    const widths = [...read.matchAll(/vp_pen_width: \(float\) ([\d.]+)/g)].map(([, text]) => Number(text));
    expect(widths.length).toBe(3);
    for (const one of widths) expect(one).toBeCloseTo(pixels(0.2), 5);
    expect([...read.matchAll(/vp_name: \(str\) (.*)/g)].map(([, name]) => name)).toEqual([
      '1 outlines',
      '2 lines',
      '3 crossing',
    ]);
  });

  test('finds next to nothing to join, and no shorter way', () => {
    const countOf = (...commands: string[]): number =>
      Number(/^ {2}Path count: (\d+)$/m.exec(totalsOf('travel', ...commands))![1]);
    const merged = ['linemerge', '-t', '0.1mm', 'linesort'];
    expect(countOf(...merged) / countOf()).toBeGreaterThan(0.98);
    expect(travelOf('travel', ...merged) / travelOf('travel')).toBeGreaterThan(0.98);
  });

  test('writes HPGL by the recipe in the docs, with a pen for each layer', () => {
    const file = join(folder, 'plot.hpgl');
    const [, command] = /`vpype read plot\.svg (write [^`]*) plot\.hpgl`/.exec(docs)!;
    spawnSync('vpype', ['read', fileOf('travel'), ...command.split(' '), file]);
    expect(new Set(readFileSync(file, 'latin1').match(/SP[1-9]/g))).toEqual(new Set(['SP1', 'SP2', 'SP3']));
  });

  test.skipIf(!hasGcode)(
    'writes G-code by the profile in the docs: the pen is down on lines alone, and on the sheet',
    () => {
      const [profile, file] = ['pen.toml', 'plot.gcode'].map((name) => join(folder, name));
      writeFileSync(profile, /```toml\n([^`]*)```/.exec(docs)![1]);
      vpype('--config', profile, 'read', fileOf('travel'), 'gwrite', '--profile', 'pen', file);
      let [isDown, lines] = [false, 0];
      for (const line of readFileSync(file, 'utf8').trim().split('\n')) {
        if (line.startsWith('M3')) isDown = line.endsWith('S90');
        const moved = /^G([01]) X([\d.]+) Y([\d.]+)/.exec(line);
        if (!moved) continue;
        const [draws, x, y] = moved.slice(1).map(Number);
        expect(isDown).toBe(draws === 1);
        lines += draws;
        expect(x).toBeLessThanOrEqual(210);
        expect(y).toBeLessThanOrEqual(190);
      }
      expect(lines).toBeGreaterThan(1000);
    },
  );

  test('sorts lines by no more than a fifth shorter way', () => {
    const ours = travelOf('travel');
    const theirs = Math.min(travelOf('drawn', 'linesort', '--two-opt'), travelOf('travel', 'linesort', '--two-opt'));
    expect(ours / theirs).toBeLessThan(1.25);
  });
});

test.skipIf(!hasPython).each(['travel', 'print'] as const)('a parser of XML says nothing: %s', (name) => {
  const parse = 'import sys, xml.dom.minidom; print(xml.dom.minidom.parse(sys.argv[1]).documentElement.tagName)';
  const { status, stdout, stderr } = spawnSync('python3', ['-c', parse, fileOf(name)], { encoding: 'utf8' });
  expect([status, stdout.trim(), stderr]).toEqual([0, 'svg', '']);
});
