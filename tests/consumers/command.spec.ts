import { type SpawnSyncReturns, spawn, spawnSync } from 'node:child_process';
import {
  existsSync,
  lstatSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { PNG } from 'pngjs';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { octahedronBinaryStl } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { DOCUMENTS } from '../unit/docs/documents.js';
import { NODE_SAMPLES, SAMPLE_CALLS } from '../unit/docs/sampleList.js';
import { installPackedLibrary, libraryFolder, projectFolder } from './packedLibrary.js';

const work = join(projectFolder, 'maps');
let script = '';

test.beforeAll(() => {
  installPackedLibrary();
  const { bin } = JSON.parse(readFileSync(join(libraryFolder, 'package.json'), 'utf8'));
  script = join(libraryFolder, bin['three-hatching']);
});

test.beforeEach(() => {
  rmSync(work, { recursive: true, force: true });
  mkdirSync(work, { recursive: true });
});

const run = (...args: string[]): SpawnSyncReturns<string> =>
  spawnSync(process.execPath, [script, ...args], { cwd: work, encoding: 'utf8' });

test('the command draws the map that the library draws', { tag: '@all' }, async ({ page }) => {
  const options = { style: 'charcoal', size: 64, tones: 5, seed: 3 } as const;
  const { status, stdout, stderr } = run(
    'tam',
    '--style',
    'charcoal',
    '--size=64',
    '--tones=5',
    '--seed=3',
    '--out',
    'a',
  );
  expect([status, stderr]).toEqual([0, '']);
  expect(stdout).toContain("TonalArtMap.load('a/map.json')");
  await page.goto('/tests/gpu/toolkit.html');
  await page.waitForFunction(() => window.toolkit !== undefined);
  const saved = await page.evaluate(async (o) => {
    const files = await (await window.toolkit.TonalArtMap.generate(o)).save();
    return Promise.all(files.map(async (file) => [file.name, [...new Uint8Array(await file.arrayBuffer())]] as const));
  }, options);
  expect(readdirSync(join(work, 'a')).sort()).toEqual(saved.map(([name]) => name).sort());
  const loaded = await page.evaluate(
    async (files) => {
      const { TonalArtMap } = window.toolkit;
      const map = await TonalArtMap.load(files.map(([name, bytes]) => new File([Uint8Array.from(bytes)], name)));
      return [map.size, map.tones, map.levels, map.report.consistent];
    },
    saved.map(([name]) => [name, [...readFileSync(join(work, 'a', name))]] as const),
  );
  expect(loaded).toEqual([64, 5, 3, true]);
  for (const [name, bytes] of saved) {
    const drawn = readFileSync(join(work, 'a', name));
    const expected = Buffer.from(bytes);
    // Node and the browser compress differently.
    if (name.endsWith('.json')) expect(drawn.equals(expected)).toBe(true);
    else expect(PNG.sync.read(drawn).data.equals(PNG.sync.read(expected).data), name).toBe(true);
  }
});

test('the command prints its help and the names of the styles', () => {
  for (const args of [[], ['--help'], ['tam', '-h']]) {
    const { status, stdout } = run(...args);
    expect(status).toBe(0);
    expect(stdout).toContain('npx three-hatching tam --style');
  }
  const { status, stdout } = run('tam', '--list');
  expect(status).toBe(0);
  expect(stdout.split('\n')).toEqual(expect.arrayContaining(['hatching', 'stippling', 'woodcut']));
});

test('the command draws the map of a preset', { tag: '@all' }, () => {
  const small = ['--size', '64', '--tones', '4', '--levels', '1'];
  expect(run('tam', '--preset', 'pencil', ...small, '--out', 'a').status).toBe(0);
  expect(run('tam', '--style', 'pencil', ...small, '--out', 'b').status).toBe(0);
  for (const name of readdirSync(join(work, 'b'))) {
    expect(readFileSync(join(work, 'a', name)).equals(readFileSync(join(work, 'b', name))), name).toBe(true);
  }
});

test('the command replaces a map only with its option, and other files never', { tag: '@all' }, () => {
  expect(run('tam', '--size', '64', '--tones', '4', '--out', 'here').status).toBe(0);
  const before = readFileSync(join(work, 'here/map.json'), 'utf8');
  const again = run('tam', '--size', '64', '--tones', '5', '--out', 'here');
  expect([again.status, again.stderr]).toEqual([
    2,
    'three-hatching: here holds a map already; add --force to replace it, or choose another folder.\n',
  ]);
  expect(readFileSync(join(work, 'here/map.json'), 'utf8')).toBe(before);
  expect(run('tam', '--size', '64', '--tones', '5', '--out', 'here', '--force').status).toBe(0);
  expect(JSON.parse(readFileSync(join(work, 'here/map.json'), 'utf8')).images).toHaveLength(5);
  writeFileSync(join(work, 'here/letter.txt'), 'Dear');
  const strange = run('tam', '--size', '64', '--out', 'here', '--force');
  expect([strange.status, strange.stderr]).toEqual([2, expect.stringContaining('here holds other files (letter.txt)')]);
  expect(readFileSync(join(work, 'here/letter.txt'), 'utf8')).toBe('Dear');
  expect(readdirSync(work)).toEqual(['here']);
});

test('the command writes into the folder that a link points to, and reports at once a folder that cannot be created', {
  tag: '@all',
}, () => {
  mkdirSync(join(work, 'real'));
  symlinkSync(join(work, 'real'), join(work, 'link'));
  expect(run('tam', '--size', '64', '--tones', '4', '--out', 'link').status).toBe(0);
  expect(lstatSync(join(work, 'link')).isSymbolicLink()).toBe(true);
  expect(readdirSync(join(work, 'real'))).toContain('map.json');
  writeFileSync(join(work, 'file'), 'mine');
  // This map would take many seconds, so the test shows that nothing of it is drawn.
  const refused = run('tam', '--style', 'stippling', '--size', '1024', '--tones', '16', '--out', 'file/x');
  expect([refused.status, refused.stderr]).toEqual([
    2,
    'three-hatching: file is not a folder; choose another name after --out.\n',
  ]);
  expect(readdirSync(work).sort()).toEqual(['file', 'link', 'real']);
});

test('every call of the command in README and guides runs', { tag: '@all' }, () => {
  test.slow();
  expect(SAMPLE_CALLS.length).toBeGreaterThan(8);
  mkdirSync(join(work, 'models'));
  writeFileSync(join(work, 'model.glb'), columnGlb());
  for (const name of ['model.stl', 'models/a.stl', 'models/b.stl'])
    writeFileSync(join(work, name), octahedronBinaryStl());
  writeFileSync(join(work, 'hand.json'), /^```json\n([\s\S]*?)^```/m.exec(DOCUMENTS['docs/hand.md'])![1]);
  for (const { line, args, input, output } of SAMPLE_CALLS) {
    // A small sheet, which is drawn fast.
    const small = args[0] === 'draw' ? ['--sheet', '30x30', '--no-shadows'] : [];
    const { status, stdout, stderr } = spawnSync(process.execPath, [script, ...args, ...small], {
      cwd: work,
      encoding: 'utf8',
      ...(input && { input: readFileSync(join(work, input)) }),
    });
    expect([line, status, stderr.match(/^three-hatching: .*/m)?.[0]]).toEqual([line, 0, undefined]);
    if (output) expect(stdout).toMatch(/^<svg [\s\S]*<\/svg>\n$/);
  }
});

test('every sample for Node runs with the library as it is packed', { tag: '@all' }, () => {
  for (const { name, code } of NODE_SAMPLES) {
    writeFileSync(join(work, `${name}.js`), code);
    const { status, stderr } = spawnSync(process.execPath, [`${name}.js`], { cwd: work, encoding: 'utf8' });
    expect([status, stderr]).toEqual([0, '']);
    expect(readFileSync(join(work, 'drawing.svg'), 'utf8')).toContain('<path');
  }
});

const REFUSED = [
  [['tam'], '--out is missing; name the folder to write the map to.'],
  [['paint', '--out', 'x'], '"paint" is not a command; the commands are tam and draw. See --help.'],
  [['draw', '--out', 'x'], 'There is no model to draw; name a file after draw.'],
  [['tam', 'x'], '"x" is an unexpected argument; name the folder after --out.'],
  [['tam', '--out', 'x', '--colour'], '--colour is not an option. See --help.'],
  [['tam', '--out', 'x', '--style', 'oil'], '--style is oil, but must be one of hatching, '],
  [['tam', '--out', 'x', '--preset', 'engraving'], '--preset is engraving, which needs no map; use one of pencil, '],
  [['tam', '--out', 'x', '--preset', 'oil'], '--preset is oil, which is not a preset; use one of pencil, '],
  [['tam', '--out', 'x', '--preset', 'pencil', '--style', 'ruled'], '--preset and --style exclude each other'],
  [['tam', '--out', 'x', '--size', '100'], '--size is 100, but must be 64, 128, 256, 512 or 1024.'],
  [['tam', '--out', 'x', '--tones', 'many'], '--tones is many, but must be a whole number.'],
  [['tam', '--out', 'x', '--stroke-texels', '9'], '--stroke-texels is 9, but must be a number from 1.2 to 2.6'],
] as const;
for (const [args, message] of REFUSED) {
  const isFirst = message === REFUSED[0][1];
  test(`the command refuses: ${args.join(' ')}`, { tag: isFirst ? [] : '@all' }, () => {
    const { status, stdout, stderr } = run(...args);
    expect([status, stdout]).toEqual([2, '']);
    expect(stderr).toContain(`three-hatching: ${message}`);
    expect(existsSync(join(work, 'x'))).toBe(false);
  });
}

test('the command, interrupted, leaves nothing behind', { tag: '@all' }, async () => {
  // This map takes many seconds, far more than to see that its folder is there.
  const options = ['--style', 'stippling', '--size', '1024', '--tones', '16', '--out', 'half'];
  const child = spawn(process.execPath, [script, 'tam', ...options], { cwd: work });
  let said = '';
  child.stderr.on('data', (text) => {
    said += text;
  });
  await expect.poll(() => readdirSync(work), { intervals: [20] }).toEqual(['half']);
  child.kill('SIGINT');
  const code = await new Promise((resolve) => child.on('close', resolve));
  expect([code, said]).toEqual([130, 'three-hatching: interrupted; nothing was written.\n']);
  expect(readdirSync(work)).toEqual([]);
});
