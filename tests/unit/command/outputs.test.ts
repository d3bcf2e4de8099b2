import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { DrawingFiles } from '../../../src/command/DrawingFiles.js';
import { expandPattern, planOutputs } from '../../../src/command/planOutputs.js';
import { UsageError } from '../../../src/command/readOptions.js';

let work: string;
beforeEach(() => {
  work = mkdtempSync(join(tmpdir(), 'three-hatching-'));
});
afterEach(() => rmSync(work, { recursive: true, force: true }));

describe('files of a pattern', () => {
  const found = async (pattern: string): Promise<string[]> =>
    (await expandPattern(`${work}/${pattern}`)).map((path) => path.slice(work.length + 1).replaceAll('\\', '/'));

  beforeEach(() => {
    for (const folder of ['a/b', 'c', '.hidden']) mkdirSync(join(work, folder), { recursive: true });
    for (const file of ['1.stl', '2.stl', '2.obj', 'a/3.stl', 'a/b/4.stl', '.5.stl', '.hidden/6.stl', 'x+y.obj'])
      writeFileSync(join(work, file), '');
    mkdirSync(join(work, 'folder.stl'));
    symlinkSync(work, join(work, 'c/loop'));
  });

  test.each([
    ['*.stl', ['1.stl', '2.stl']],
    ['?.*', ['1.stl', '2.obj', '2.stl']],
    ['[13-9].stl', ['1.stl']],
    ['[!1].stl', ['2.stl']],
    ['{2,a/3}.{stl,obj}', ['2.obj', '2.stl', 'a/3.stl']],
    ['**/*.stl', ['1.stl', '2.stl', 'a/3.stl', 'a/b/4.stl']],
    ['a/*/4.stl', ['a/b/4.stl']],
    ['*+*', ['x+y.obj']],
    ['.*.stl', ['.5.stl']],
    ['nowhere/*.stl', []],
  ])('%s', async (pattern, files) => {
    expect(await found(pattern)).toEqual(files);
  });
});

describe('names of drawings', () => {
  const names = (...args: Parameters<typeof planOutputs>): string[] =>
    planOutputs(...args).flatMap(({ outputs }) => outputs.map((path) => path.replaceAll('\\', '/')));

  test('one model gives one file, or one in a folder', () => {
    expect(names(['m/a.obj'], 'b.svg', false, undefined)).toEqual(['b.svg']);
    expect(names(['m/a.obj'], 'out/', false, undefined)).toEqual(['out/a.svg']);
    expect(names(['m/a.ply.gz'], 'out', true, undefined)).toEqual(['out/a.svg']);
    expect(names(['m/a$&.obj'], 'out/{name}!.svg', false, undefined)).toEqual(['out/a$&!.svg']);
  });

  test('several models give one file each, distinguished by extension if necessary', () => {
    expect(names(['a.obj', 'b.stl', 'b.glb'], 'out', false, undefined)).toEqual([
      'out/a.svg',
      'out/b.stl.svg',
      'out/b.glb.svg',
    ]);
    expect(() => names(['m/a.obj', 'n/a.obj'], 'out', false, undefined)).toThrow(
      'm/a.obj and n/a.obj would both be drawn to out/a.obj.svg; draw them into different folders, or one by one.',
    );
    expect(() => names(['a.obj', 'b.obj'], 'out/{frame}.svg', false, 2)).toThrow(
      'a.obj and b.obj would both be drawn to out/1.svg; give --out a name with {name}, or draw them one by one.',
    );
  });

  test('frames are numbered with as many digits as the last one has', () => {
    expect(names(['a.obj'], 'b.svg', false, 10).slice(0, 2)).toEqual(['b-01.svg', 'b-02.svg']);
    expect(names(['a.obj'], 'b/{frame}.svg', false, 2)).toEqual(['b/1.svg', 'b/2.svg']);
    expect(names(['a.obj', 'b.obj'], 'out', false, 2)).toEqual([
      'out/a-1.svg',
      'out/a-2.svg',
      'out/b-1.svg',
      'out/b-2.svg',
    ]);
    expect(() => names(['a.obj', 'b.obj'], 'out/{frame}.svg', false, 2)).toThrow(UsageError);
  });

  test('a drawing does not overwrite a model', () => {
    expect(() => names(['a.svg'], './a.svg', false, undefined)).toThrow('which is a model');
  });

  test.each(['a.dxf', 'out/a.HPGL', 'a.svgz', '{name}.pdf'])('%s is refused with what to do', (out) => {
    expect(() => names(['a.obj'], out, false, undefined)).toThrow(
      `--out is ${out}, but only SVG and DXF are written; name a file that ends in .svg, which Inkscape and vpype turn into other formats.`,
    );
  });

  test('DXF files end so, in a folder too', () => {
    const ofDxf = (out: string, isFolder = false) => planOutputs(['a.obj'], out, isFolder, undefined, 'dxf')[0].outputs;
    expect([ofDxf('b.dxf'), ofDxf('out', true)]).toEqual([['b.dxf'], ['out/a.dxf']]);
    expect(() => ofDxf('b.svg')).toThrow('--out is b.svg, but DXF is written; name a file that ends in .dxf.');
  });

  test('an ending in capitals, none at all and a folder with a dot are as they are', () => {
    expect(names(['a.obj'], 'b.SVG', false, undefined)).toEqual(['b.SVG']);
    expect(names(['a.obj'], 'b', false, undefined)).toEqual(['b']);
    expect(names(['a.v2.obj'], '{name}', false, undefined)).toEqual(['a.v2']);
    expect(names(['a.obj', 'b.obj'], 'v1.2/', false, undefined)).toEqual(['v1.2/a.svg', 'v1.2/b.svg']);
  });

  test('one file for several models is refused, and no folder of its name is made', () => {
    expect(() => names(['a.obj', 'b.obj'], 'one.svg', false, undefined)).toThrow(
      '--out is one.svg, one file, but there are several models; name a folder, or a file with {name}, as {name}.svg.',
    );
    expect(names(['a.obj', 'b.obj'], 'one.svg', true, undefined)).toEqual(['one.svg/a.svg', 'one.svg/b.svg']);
  });

  test('the standard output takes one drawing, and the standard input gives a name', () => {
    expect(names(['m/a.obj'], '-', false, undefined)).toEqual(['-']);
    expect(() => names(['a.obj', 'b.obj'], '-', false, undefined)).toThrow('the standard output takes one drawing');
    expect(() => names(['a.obj'], '-', false, 2)).toThrow('the standard output takes one drawing');
    expect(names(['-'], 'out', true, undefined)).toEqual(['out/stdin.svg']);
  });
});

describe('the files of drawings', () => {
  const tree = (): string[] => readdirSync(work, { recursive: true }).map(String).sort();

  test('are written to folders that are created for them', async () => {
    const files = new DrawingFiles(false);
    const path = join(work, 'a/b/1.svg');
    await files.open([path]);
    const writing = files.write(path, 'drawing');
    expect(existsSync(path)).toBe(false);
    await writing;
    await files.close();
    expect(readFileSync(path, 'utf8')).toBe('drawing');
    expect(tree()).toEqual(['a', 'a/b', 'a/b/1.svg']);
  });

  test('leave nothing behind if none is written, not even folders', async () => {
    const files = new DrawingFiles(false);
    await files.open([join(work, 'a/b/1.svg')]);
    await files.close();
    expect(tree()).toEqual([]);
  });

  test('replace existing files only with --force, also files that appear later', async () => {
    const path = join(work, '1.svg');
    const files = new DrawingFiles(false);
    await files.open([path]);
    writeFileSync(path, 'mine');
    await expect(files.write(path, 'drawing')).rejects.toThrow(/1\.svg is there already; add --force/);
    await expect(new DrawingFiles(false).open([path])).rejects.toThrow(UsageError);
    expect(tree()).toEqual(['1.svg']);
    expect(readFileSync(path, 'utf8')).toBe('mine');
    const forced = new DrawingFiles(true);
    await forced.open([path]);
    await forced.write(path, 'drawing');
    expect(readFileSync(path, 'utf8')).toBe('drawing');
  });

  test('do not replace folders', async () => {
    mkdirSync(join(work, '1.svg'));
    await expect(new DrawingFiles(true).open([join(work, '1.svg')])).rejects.toThrow(/1\.svg is not a file/);
    await expect(new DrawingFiles(true).open([join(work, '1.svg/a/2.svg')])).resolves.toBeUndefined();
  });
});
