import { type ChildProcess, spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { afterEach, beforeAll, beforeEach, describe, expect, test } from 'vitest';
import { version } from '../../../package.json';
import { drawModel } from '../../../src/command/draw/drawModel.js';
import type { DrawMessage } from '../../../src/command/draw.js';
import { type DrawingOptions, parseDrawing } from '../../../src/command/parseDrawing.js';
import { octahedronGlb, octahedronObj, octahedronPly } from '../../../tools/modelFiles/modelFiles.js';

const root = fileURLToPath(new URL('../../..', import.meta.url));
/** Within the project, so that it finds three. */
const outDir = join(root, 'tests/output/command');

beforeAll(async () => {
  const configFile = join(root, 'tools/building/vite.lib.config.ts');
  for (const mode of ['production', 'command', 'draw'])
    await build({ root, configFile, mode, logLevel: 'error', build: { outDir } });
});

let work: string;
let running: ChildProcess | undefined;
beforeEach(() => {
  work = mkdtempSync(join(tmpdir(), 'three-hatching-'));
  writeFileSync(join(work, 'a.obj'), octahedronObj);
});
afterEach(() => {
  running?.kill('SIGKILL');
  rmSync(work, { recursive: true, force: true });
});

interface Ended {
  code: number | null;
  stdout: string;
  stderr: string;
}

/** Runs the built command in the folder of the test. @param onText is given what it has said so far. @param input of its standard input */
function run(
  args: readonly string[],
  onText: (text: string, command: ChildProcess) => void = () => {},
  input: string | Uint8Array = '',
): Promise<Ended> {
  const command = spawn(process.execPath, [join(outDir, 'command.js'), ...args], { cwd: work });
  running = command;
  command.stdin.on('error', () => {}).end(input);
  const said = { stdout: '', stderr: '' };
  for (const name of ['stdout', 'stderr'] as const)
    command[name].setEncoding('utf8').on('data', (text: string) => {
      said[name] += text;
      onText(said.stdout + said.stderr, command);
    });
  return new Promise((resolve) => command.on('close', (code) => resolve({ code, ...said })));
}

const draw = (...args: string[]): Promise<Ended> => run(['draw', ...args]);
/** A sheet that is soon drawn. */
const SMALL = ['--sheet', '60x60'] as const;
const tree = (): string[] => readdirSync(work, { recursive: true }).map(String).sort();

test('draws the same bytes as its source', { tags: ['all'] }, async () => {
  const args = ['a.obj', '--pen', '0.5', '--sheet', '90x60', '--out', 'out/a.svg'];
  const { code, stdout } = await draw(...args);
  expect(code).toBe(0);
  expect(stdout).toMatch(
    /^out\/a\.svg: [\d,]+ paths, \d+\.\d\d m drawn, \d+\.\d\d m of travel \(\d+\.\d\d m before ordering\),( about \d+ min to plot,)? [\d.]+ s\.\n(out\/a\.svg, [a-z]+: [\d,]+ paths?, [\d.]+ m(, about \d+ min)?\n)*$/,
  );
  const { options } = parseDrawing(args) as { options: DrawingOptions };
  const messages: DrawMessage[] = [];
  await drawModel({ model: join(work, 'a.obj'), options }, (message) => messages.push(message));
  const [drawing] = messages.flatMap((message) => (message.kind === 'drawing' ? [message.texts[0].text] : []));
  expect(readFileSync(join(work, 'out/a.svg'), 'utf8')).toBe(drawing);
  expect(tree()).toEqual(['a.obj', 'out', 'out/a.svg']);
});

describe('standard input and output', () => {
  test('- reads a model and writes its drawing; messages go to the standard error', async () => {
    const { code, stdout, stderr } = await run(['draw', '-', '--out', '-', ...SMALL], undefined, octahedronGlb());
    expect(code).toBe(0);
    expect(stdout).toMatch(/^<svg [\s\S]*<\/svg>\n$/);
    expect(stderr).toMatch(
      /^the standard output: [\d,]+ paths, [^\n]* s\.\n(the standard output, [a-z]+: [\d,]+ paths?, [\d.]+ m(, about \d+ min)?\n)*$/,
    );
    expect(tree()).toEqual(['a.obj']);
  });

  test('the drawing is that of a file, byte for byte', { tags: ['all'] }, async () => {
    const [piped, filed] = [
      await draw('a.obj', '--out', '-', ...SMALL),
      await draw('a.obj', '--out', 'a.svg', ...SMALL),
    ];
    expect([piped.code, filed.code]).toEqual([0, 0]);
    expect(piped.stdout).toBe(readFileSync(join(work, 'a.svg'), 'utf8'));
  });

  test('--format says what a model is; a folder has it as stdin', { tags: ['all'] }, async () => {
    const comment = `# not a vertex first\n${'# \n'.repeat(2000)}${octahedronObj}`;
    const args = ['draw', '-', '--out', 'out/', ...SMALL];
    const unknown = await run(args, undefined, comment);
    expect([unknown.code, unknown.stderr]).toEqual([1, expect.stringMatching(/^three-hatching: stdin is not a model/)]);
    const { code, stdout } = await run([...args, '--format', 'obj'], undefined, comment);
    expect([code, stdout]).toEqual([0, expect.stringMatching(/^out\/stdin\.svg: /)]);
  });

  test('an empty input, and a reader that stops before the end, are said in a sentence', async () => {
    const empty = await run(['draw', '-', '--out', 'b.svg']);
    expect([empty.code, empty.stderr]).toEqual([1, 'three-hatching: stdin is empty.\n']);
    writeFileSync(join(work, 'b.glb'), octahedronGlb());
    const closed = run(['draw', 'b.glb', '--out', '-', ...SMALL]);
    running?.stdout?.destroy();
    const { code, stderr } = await closed;
    expect([code, stderr]).toEqual([
      1,
      'three-hatching: The standard output was closed before the whole drawing was written.\n',
    ]);
  });
});

describe('several models', { tags: ['all'] }, () => {
  test('are drawn by pattern and in parallel; failed ones are named, and the exit code is 1', async () => {
    writeFileSync(join(work, 'b.ply'), octahedronPly);
    writeFileSync(join(work, 'c.glb'), octahedronGlb());
    writeFileSync(join(work, 'broken.glb'), octahedronGlb().subarray(0, 500));
    writeFileSync(join(work, 'empty.obj'), '');
    const { code, stdout, stderr } = await draw('*.{obj,ply,glb}', 'gone.stl', '--out', 'out', '--jobs', '3', ...SMALL);
    expect(code).toBe(1);
    expect(readdirSync(join(work, 'out')).sort()).toEqual(['a.svg', 'b.svg', 'c.svg']);
    expect(stdout.trim().split('\n')).toHaveLength(3);
    const failures = stderr.split('\n').filter((line) => line.startsWith('three-hatching: '));
    expect(failures.sort()).toEqual([
      expect.stringMatching(/^three-hatching: broken\.glb is cut short/),
      'three-hatching: empty.obj is empty.',
      'three-hatching: gone.stl is not there.',
    ]);
  });

  test('a model that is named twice is drawn once; a folder is none, nor is an address', async () => {
    const absent = ['https://example.org/c.glb', '~/d.obj'];
    mkdirSync(join(work, 'sub'));
    const { code, stdout, stderr } = await draw('a.obj', './a.obj', 'sub', ...absent, '--out', 'out', ...SMALL);
    expect([code, stdout]).toEqual([1, expect.stringMatching(/^out\/a\.svg: [^\n]*\n$/)]);
    expect(stderr.split('\n').filter((line) => line.startsWith('three-hatching: '))).toEqual([
      'three-hatching: sub is a folder; name models in it, as "sub/*.glb" in quotes.',
      'three-hatching: https://example.org/c.glb is not there: nothing is fetched, so save the file first.',
      'three-hatching: ~/d.obj is not there: shells expand ~ only outside of quotes.',
    ]);
  });

  test('give numbered files each, with as many frames as are asked for', async () => {
    const { code } = await draw('a.obj', '--frames', '3', '--no-shadows', '--out', 'turn/{name}.svg', ...SMALL);
    expect(code).toBe(0);
    expect(readdirSync(join(work, 'turn')).sort()).toEqual(['a-1.svg', 'a-2.svg', 'a-3.svg']);
  });
});

describe('how it ends', () => {
  test('0 for help, of which there is one for each command, and for the version', async () => {
    const [all, one] = [await run([]), await draw('--help')];
    expect([all.code, one.code]).toEqual([0, 0]);
    for (const args of [['--version'], ['draw', '--version']])
      expect(await run(args)).toEqual({ code: 0, stdout: `${version}\n`, stderr: '' });
    expect(all.stdout).toContain('npx three-hatching draw --help');
    expect(one.stdout).toContain('--pen <mm>');
  });

  test.each([
    [['draw', 'a.obj'], '--out is missing'],
    [['draw', 'a.obj', '--out', 'a.svg', '--pen', 'x'], '--pen is x'],
    [['draw', '*.zip', '--out', 'a.svg'], '*.zip matches no file'],
    [['draw', 'a.obj', '--out', 'a.pdf'], 'only SVG and DXF are written'],
    [['draw', 'a.obj', '-', '--out', 'one.svg'], 'one file, but there are several models'],
    [['draw', 'a.obj', '--out', '-', '--frames', '2'], 'the standard output takes one drawing'],
    [['paint'], '"paint" is not a command; the commands are tam and draw.'],
  ])('2 for a wrong call: %j', async (args, sentence) => {
    const { code, stdout, stderr } = await run(args);
    expect(code).toBe(2);
    expect(stdout).toBe('');
    expect(stderr).toMatch(/^three-hatching: [^\n]+\.\n$/);
    expect(stderr).toContain(sentence);
    expect(tree()).toEqual(['a.obj']);
  });

  test('2 for a file that is there, unless it may be replaced', { tags: ['all'] }, async () => {
    writeFileSync(join(work, 'a.svg'), 'mine');
    const refused = await draw('a.obj', '--out', 'a.svg');
    expect([refused.code, refused.stderr]).toEqual([2, expect.stringContaining('add --force to replace it')]);
    expect(readFileSync(join(work, 'a.svg'), 'utf8')).toBe('mine');
    expect((await draw('a.obj', '--out', 'a.svg', '--force', ...SMALL)).code).toBe(0);
    expect(readFileSync(join(work, 'a.svg'), 'utf8')).toContain('<svg');
  });

  test('1 if nothing is drawn, which leaves nothing behind', async () => {
    writeFileSync(join(work, 'b.obj'), 'v 0 0 0\n');
    const { code, stderr } = await draw('b.obj', '--out', 'out/b.svg');
    expect(code).toBe(1);
    expect(stderr).toMatch(/^three-hatching: [^\n]*b\.obj[^\n]*\.\n$/);
    expect(tree()).toEqual(['a.obj', 'b.obj']);
  });

  test.skipIf(process.platform === 'win32')(
    '130 if it is interrupted, with whole files or none',
    { tags: ['all'] },
    async () => {
      let isStopped = false;
      const frames = ['--frames', '400', '--jobs', '2', '--out', 'turn', ...SMALL];
      writeFileSync(join(work, 'b.obj'), octahedronObj);
      const { code, stderr } = await run(['draw', 'a.obj', 'b.obj', ...frames], (text, command) => {
        if (isStopped || !text.includes('a-002.svg: ')) return;
        isStopped = true;
        command.kill('SIGINT');
      });
      expect(code).toBe(130);
      expect(stderr).toMatch(/three-hatching: interrupted; \d+ files were written before that\.\n$/);
      const names = readdirSync(join(work, 'turn'));
      expect(names).toContain('a-002.svg');
      expect(names).not.toContain('a-400.svg');
      for (const name of names) expect(readFileSync(join(work, 'turn', name), 'utf8')).toMatch(/<\/svg>\s*$/);
    },
  );

  describe.skipIf(process.platform === 'win32')('130 before anything is drawn, with nothing left behind', () => {
    test.each(['SIGINT', 'SIGHUP'] as const)('by %s', { tags: ['all'] }, async (name) => {
      const ended = run(['draw', 'a.obj', '--out', 'out/a.svg']);
      while (!existsSync(join(work, 'out'))) await new Promise((resume) => setTimeout(resume, 2));
      running?.kill(name);
      const { code, stderr } = await ended;
      expect([code, stderr]).toEqual([130, 'three-hatching: interrupted; nothing was written.\n']);
      expect(tree()).toEqual(['a.obj']);
    });
  });
});

test('control characters in names do not move the cursor', { tags: ['all'] }, async () => {
  const name = 'a\u001b[2Jb.obj';
  writeFileSync(join(work, name), '');
  const { stderr } = await draw(name, '--out', 'a.svg');
  expect(stderr).toContain('is empty.');
  expect(stderr).not.toContain('\u001b');
});
