import {
  existsSync,
  lstatSync,
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
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { OutputFolder } from '../../../src/command/OutputFolder.js';
import { UsageError } from '../../../src/command/readOptions.js';

/** What a call of the file system fails with, if it is to. Root may do anything, and no disk here is full. */
const fault = vi.hoisted(() => ({
  of: (_call: string, _path: string, _bytes: number): string | undefined => undefined,
}));

vi.mock('node:fs/promises', async (importOriginal) => {
  const real = await importOriginal<Record<string, (...args: unknown[]) => unknown>>();
  return Object.fromEntries(
    Object.entries(real).map(([name, call]) => [
      name,
      typeof call === 'function'
        ? async (...args: unknown[]) => {
            const [path, content] = args as [string, Uint8Array?];
            const code = fault.of(name, path, content?.byteLength ?? 0);
            if (code) throw Object.assign(new Error(`${code}: raw`), { code });
            return call(...args);
          }
        : call,
    ]),
  );
});

let work: string;
let out: string;
beforeEach(() => {
  work = mkdtempSync(join(tmpdir(), 'three-hatching-'));
  out = join(work, 'a/b');
});
afterEach(() => {
  fault.of = () => undefined;
  rmSync(work, { recursive: true, force: true });
});

const files = (...names: string[]) => names.map((name) => ({ name, bytes: Buffer.from(`new ${name}`) }));
const MAP = files('map.json', 'tone-0-level-0.png');
const { signal } = new AbortController();

/** What the command does, beside drawing. */
async function run(path: string, { force = false, meanwhile = () => {} } = {}): Promise<void> {
  const folder = new OutputFolder(path, force);
  try {
    await folder.open(1000);
    meanwhile();
    await folder.write(MAP, signal);
  } finally {
    await folder.close();
  }
}

const tree = (): string[] => readdirSync(work, { recursive: true }).map(String).sort();
const contentOf = (...path: string[]): string => readFileSync(join(...path), 'utf8');

describe('the folder of a map', () => {
  test('is created with its parents, and holds only the files of the map', async () => {
    await run(out);
    expect(tree()).toEqual(['a', 'a/b', 'a/b/map.json', 'a/b/tone-0-level-0.png']);
    expect(contentOf(out, 'map.json')).toBe('new map.json');
  });

  test('may exist, and may hold a map that is replaced', async () => {
    mkdirSync(out, { recursive: true });
    for (const name of ['map.json', 'tone-7-level-0.png']) writeFileSync(join(out, name), 'old');
    await expect(run(out)).rejects.toThrow(/holds a map already; add --force to replace it/);
    expect(contentOf(out, 'map.json')).toBe('old');
    await run(out, { force: true });
    expect(readdirSync(out)).toEqual(['map.json', 'tone-0-level-0.png']);
    expect(contentOf(out, 'map.json')).toBe('new map.json');
  });

  test('may be a link, and stays one', async () => {
    mkdirSync(join(work, 'real'));
    symlinkSync(join(work, 'real'), join(work, 'link'));
    await run(join(work, 'link'));
    await run(join(work, 'link'), { force: true });
    expect(lstatSync(join(work, 'link')).isSymbolicLink()).toBe(true);
    expect(readdirSync(join(work, 'real'))).toEqual(['map.json', 'tone-0-level-0.png']);
  });

  test('keeps a folder of the name map.json, and a link of that name, forced or not', async () => {
    mkdirSync(join(out, 'map.json'), { recursive: true });
    writeFileSync(join(out, 'map.json/letter.txt'), 'Dear');
    for (const force of [true, false]) {
      await expect(run(out, { force })).rejects.toThrow(/holds other files \(map\.json\); choose a folder of its own/);
    }
    expect(contentOf(out, 'map.json/letter.txt')).toBe('Dear');
    rmSync(join(out, 'map.json'), { recursive: true });
    symlinkSync(join(work, 'elsewhere'), join(out, 'map.json'));
    await expect(run(out, { force: true })).rejects.toThrow(/holds other files \(map\.json\)/);
  });

  test('keeps files that others wrote while the map was drawn', async () => {
    const meanwhile = (): void => writeFileSync(join(out, 'letter.txt'), 'Dear');
    await expect(run(out, { meanwhile })).rejects.toThrow(/holds other files \(letter\.txt\)/);
    expect(tree()).toEqual(['a', 'a/b', 'a/b/letter.txt']);
  });

  test('is removed with its created parents if the drawing is aborted', async () => {
    const folder = new OutputFolder(out, false);
    await folder.open(1000);
    await expect(folder.write(MAP, AbortSignal.abort(new Error('enough')))).rejects.toThrow('enough');
    await folder.close();
    expect(tree()).toEqual([]);
  });
});

describe('obstacles are reported before anything is drawn, in one sentence', () => {
  const refused = async (path: string): Promise<string> => {
    const meanwhile = vi.fn();
    const error = await run(path, { meanwhile }).catch((reason) => reason);
    expect(error).toBeInstanceOf(UsageError);
    expect(meanwhile).not.toHaveBeenCalled();
    return error.message;
  };

  test('a file in its place, or above it', async () => {
    writeFileSync(join(work, 'a'), 'mine');
    const says = `${join(work, 'a')} is not a folder; choose another name after --out.`;
    expect(await refused(join(work, 'a'))).toBe(says);
    expect(await refused(join(work, 'a/b/c'))).toBe(says);
    expect(contentOf(work, 'a')).toBe('mine');
  });

  test('too long a name', async () => {
    expect(await refused(join(work, 'a', 'x'.repeat(300)))).toMatch(
      /…x{60} has too long a name; choose a shorter one after --out\.$/,
    );
    expect(tree()).toEqual([]);
  });

  test('a link that leads nowhere, or to itself', async () => {
    symlinkSync(join(work, 'nowhere'), join(work, 'link'));
    symlinkSync(join(work, 'loop'), join(work, 'loop'));
    expect(await refused(join(work, 'link'))).toMatch(/link is a link that leads nowhere, or not a folder; choose/);
    expect(await refused(join(work, 'loop/a'))).toMatch(/loop(\/a)? is a link that leads to itself; choose/);
  });

  test.runIf(existsSync('/proc/self'))(
    'a place where no folder can be made, where Node would try for ever',
    async () => {
      expect(await refused('/proc/x/y')).toBe('/proc/x cannot be made there; choose another folder after --out.');
    },
  );

  test('a disk with less room than the map may need', async () => {
    fault.of = (name, _, bytes) => (name === 'writeFile' && bytes > 900 ? 'ENOSPC' : undefined);
    expect(await refused(out)).toMatch(/b lies on a disk that is full; make room there/);
  });

  test.each([
    ['EACCES', 'mkdir', /b may not be written to; change its permissions, or choose another folder/],
    ['EPERM', 'mkdir', /b may not be written to/],
    ['EROFS', 'mkdir', /b lies on a read-only disk; choose another folder/],
    ['EACCES', 'readdir', /b may not be written to/],
    ['EACCES', 'stat', /b may not be written to/],
    ['ENOSPC', 'mkdir', /b lies on a disk that is full; make room there/],
    ['ENOSPC', 'writeFile', /b lies on a disk that is full; make room there/],
    ['EDQUOT', 'writeFile', /b lies where there is no room left for you; make room/],
    ['EIO', 'writeFile', /b could not be written \(EIO\); choose another folder after --out\.$/],
  ])('%s of %s', async (code, call, says) => {
    fault.of = (name, path) => (name === call && path.startsWith(out) ? code : undefined);
    const sentence = await refused(out);
    expect(sentence).toMatch(says);
    expect(sentence).not.toContain('raw');
    fault.of = () => undefined;
    expect(tree()).toEqual([]);
  });
});

describe('a disk that fails once the map is drawn', () => {
  test.each([
    ['the first file', 'writeFile', 1],
    ['the last file', 'writeFile', 2],
    ['the first move', 'rename', 1],
    ['the last move', 'rename', 4],
  ])('leaves all as it was: %s', async (_, call, nth) => {
    mkdirSync(out, { recursive: true });
    for (const name of ['map.json', 'tone-7-level-0.png']) writeFileSync(join(out, name), 'old');
    let calls = 0;
    const meanwhile = (): void => {
      fault.of = (name) => (name === call && ++calls === nth ? 'ENOSPC' : undefined);
    };
    const error = await run(out, { force: true, meanwhile }).catch((reason) => reason);
    expect(error).not.toBeInstanceOf(UsageError);
    expect(error.message).toBe(
      `${out} lies on a disk that is full; make room there, or choose another folder after --out.`,
    );
    expect(readdirSync(out)).toEqual(['map.json', 'tone-7-level-0.png']);
    expect(contentOf(out, 'map.json')).toBe('old');
  });
});
